import {
  Box3,
  BufferAttribute,
  BufferGeometry,
  Float32BufferAttribute,
  InterleavedBuffer,
  InterleavedBufferAttribute,
  IntType,
  Sphere,
  Vector3,
} from 'three';
import { expect, it } from 'vitest';
import { freeChannel, GatheredAttributes, litGeometry } from './litGeometry';

/** A triangle with an attribute of each kind, and all other parts of a geometry. */
function source(): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new Float32BufferAttribute([0, 1, 2, 3, 4, 5, 6, 7, 8], 3));
  geometry.setAttribute('color', new BufferAttribute(Uint8Array.from([0, 51, 102, 153, 204, 255]), 2, true));
  const packed = new InterleavedBuffer(Float32Array.from([9, 10, 11, 19, 20, 21, 29, 30, 31]), 3);
  geometry.setAttribute('uv', new InterleavedBufferAttribute(packed, 2, 1));
  const whole = new BufferAttribute(Int32Array.from([5, 6, 7]), 1);
  whole.gpuType = IntType;
  geometry.setAttribute('bone', whole);
  geometry.morphAttributes.position = [new Float32BufferAttribute([1, 1, 1, 2, 2, 2, 3, 3, 3], 3)];
  geometry.morphTargetsRelative = true;
  geometry.addGroup(0, 3, 2);
  geometry.setDrawRange(0, 3);
  geometry.boundingBox = new Box3(new Vector3(), new Vector3(6, 7, 8));
  geometry.boundingSphere = new Sphere(new Vector3(3, 4, 5), 9);
  return Object.assign(geometry, { name: 'sheet', userData: { from: 'a file' } });
}

/** The triangle's corners in reverse order, and the first one again. */
const unwrapped = {
  uv1: Float32Array.from([0, 0, 0.5, 0, 0.5, 0.5, 1, 1]),
  index: Uint32Array.from([3, 1, 0]),
  sourceVertex: Uint32Array.from([2, 1, 0, 0]),
};

it('has all that its source has, its vertices in the order of the new UVs', () => {
  const geometry = source();
  const lit = litGeometry(geometry, unwrapped, 2, new GatheredAttributes());
  const values = (name: string) => Array.from({ length: 4 }, (_, i) => lit.attributes[name].getX(i));
  expect(values('position')).toEqual([6, 3, 0, 0]);
  expect(values('uv')).toEqual([30, 20, 10, 10]);
  expect(values('bone')).toEqual([7, 6, 5, 5]);
  expect(values('color')).toEqual([204 / 255, 102 / 255, 0, 0]);
  expect(lit.attributes.color.normalized).toBe(true);
  expect((lit.attributes.bone as BufferAttribute).gpuType).toBe(IntType);
  expect([...lit.morphAttributes.position![0].array]).toEqual([3, 3, 3, 2, 2, 2, 1, 1, 1, 1, 1, 1]);
  expect([...lit.attributes.uv2.array]).toEqual([...unwrapped.uv1]);
  expect([...lit.index!.array]).toEqual([3, 1, 0]);
  for (const name of ['name', 'userData', 'morphTargetsRelative', 'groups', 'drawRange'] as const)
    expect(lit[name], name).toEqual(geometry[name]);
  for (const name of ['boundingBox', 'boundingSphere'] as const) {
    expect(lit[name], name).toEqual(geometry[name]);
    expect(lit[name], name).not.toBe(geometry[name]);
  }
  expect(lit.groups[0]).not.toBe(geometry.groups[0]);
  expect(Object.keys(geometry.attributes), 'of the source').toEqual(['position', 'color', 'uv', 'bone']);
});

it('meshes of one geometry and order share what was gathered, those of another order do not', () => {
  const geometry = source();
  const attributes = new GatheredAttributes();
  const [one, same, other] = [
    unwrapped,
    { ...unwrapped, sourceVertex: unwrapped.sourceVertex.slice() },
    { ...unwrapped, sourceVertex: Uint32Array.from([0, 1, 2, 0]) },
  ].map((each) => litGeometry(geometry, each, 1, attributes));
  expect(same.attributes.position).toBe(one.attributes.position);
  expect(same.attributes.uv1).not.toBe(one.attributes.uv1);
  expect(other.attributes.position).not.toBe(one.attributes.position);
});

it('the set of UVs is the first that no geometry has', () => {
  const withSets = (...names: string[]): BufferGeometry => {
    const geometry = new BufferGeometry();
    for (const name of names) geometry.setAttribute(name, new BufferAttribute(new Float32Array(2), 2));
    return geometry;
  };
  expect(freeChannel([withSets('uv')])).toBe(1);
  expect(freeChannel([withSets('uv', 'uv1'), withSets('uv')])).toBe(2);
  expect(freeChannel([withSets('uv1'), withSets('uv2')])).toBe(3);
  expect(freeChannel([withSets('uv1', 'uv2', 'uv3')])).toBe(3);
});
