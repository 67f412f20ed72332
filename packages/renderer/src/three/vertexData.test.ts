import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  GLBufferAttribute,
  InterleavedBuffer,
  InterleavedBufferAttribute,
} from 'three';
import { expect, test } from 'vitest';
import {
  attributeId,
  attributeState,
  attributeVersion,
  hasReadableVertices,
  isReadable,
  type VertexAttribute,
} from './vertexData';

const buffer = () => new InterleavedBuffer(new Float32Array(12), 6);

test('the number of an attribute is that of what holds its data, and changes with it', () => {
  const shared = buffer();
  const positions = new InterleavedBufferAttribute(shared, 3, 0);
  const normals = new InterleavedBufferAttribute(shared, 3, 3);
  const foreign = new GLBufferAttribute({}, 5126, 3, 4, 2);
  const all: VertexAttribute[] = [
    positions,
    normals,
    new InterleavedBufferAttribute(buffer(), 3, 0),
    new BufferAttribute(new Float32Array(6), 3),
    new BufferAttribute(new Float32Array(6), 3),
    foreign,
    new GLBufferAttribute({}, 5126, 3, 4, 2),
  ];
  const ids = all.map(attributeId);
  expect(new Set(ids).size).toBe(all.length);
  expect(all.map(attributeId)).toEqual(ids);
  expect(attributeId(new InterleavedBufferAttribute(shared, 3, 0))).toBe(ids[0]);
  positions.data = buffer();
  foreign.setBuffer({} as WebGLBuffer);
  expect(ids).not.toContain(attributeId(positions));
  expect(ids).not.toContain(attributeId(foreign));
});

test('the version is that of the data, of interleaved attributes of the buffer that they share', () => {
  const shared = buffer();
  const all = [
    new InterleavedBufferAttribute(shared, 3, 0),
    new BufferAttribute(new Float32Array(6), 3),
    new GLBufferAttribute({}, 5126, 3, 4, 2),
  ];
  expect(all.map(attributeVersion)).toEqual([0, 0, 0]);
  for (const each of all) each.needsUpdate = true;
  shared.needsUpdate = true;
  expect(all.map(attributeVersion)).toEqual([2, 1, 1]);
  const states = all.map(attributeState);
  expect(new Set(states).size).toBe(3);
  shared.needsUpdate = true;
  expect(attributeState(all[0])).not.toBe(states[0]);
});

test('what the page has let go of, and what is on the GPU alone, is not readable', () => {
  const interleaved = new InterleavedBufferAttribute(buffer(), 3, 3);
  const plain = new BufferAttribute(new Float32Array(6), 3);
  expect([interleaved, plain].map(isReadable)).toEqual([true, true]);
  interleaved.data.array = new Float32Array(0);
  (plain as { array: unknown }).array = null;
  const foreign = new GLBufferAttribute({}, 5126, 3, 4, 2);
  expect([interleaved, plain, foreign].map(isReadable)).toEqual([false, false, false]);
  const box = new BoxGeometry();
  expect([box, new BufferGeometry()].map(hasReadableVertices)).toEqual([true, false]);
  box.index!.array = new Uint16Array(0);
  expect(hasReadableVertices(box)).toBe(false);
});
