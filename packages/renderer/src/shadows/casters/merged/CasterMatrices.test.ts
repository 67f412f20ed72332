import { Euler, Matrix4, Quaternion, Vector3, type WebGLRenderer } from 'three';
import { expect, it } from 'vitest';
import { CasterMatrices } from './CasterMatrices';

/** A renderer with one uniform buffer, kept as an array, that counts the floats uploaded to it. */
function bufferedRenderer() {
  const found = { buffer: new Float32Array(0), sent: 0 };
  const gl = {
    ...{ MAX_UNIFORM_BUFFER_BINDINGS: 1, MAX_UNIFORM_BLOCK_SIZE: 2, UNIFORM_BUFFER: 3, DYNAMIC_DRAW: 4 },
    getParameter: (name: number) => (name === 1 ? 24 : 16_384),
    createBuffer: () => ({}),
    bindBuffer: () => {},
    bufferData: (_: number, data: Float32Array) => {
      found.buffer = data.slice();
      found.sent += data.length;
    },
    bufferSubData(_: number, byte: number, data: Float32Array, first: number, count: number) {
      found.buffer.set(data.subarray(first, first + count), byte / 4);
      found.sent += count;
    },
  };
  return { found, webgl: { getContext: () => gl } as unknown as WebGLRenderer };
}

const pose = (i: number): Matrix4 =>
  new Matrix4().compose(
    new Vector3(i, 10 + i, 20 + i),
    new Quaternion().setFromEuler(new Euler(i, 2 * i, 3 * i)),
    new Vector3(1, 2, 3),
  );

it('sends all twelve numbers of each matrix that has changed, relative to the origin, and none of the others', () => {
  const { found, webgl } = bufferedRenderer();
  const matrices = new CasterMatrices(webgl);
  const origin = new Vector3(1, 2, 3);
  const poses = Array.from({ length: 8 }, (_, i) => pose(i));
  const rowsOf = (matrix: Matrix4): number[] =>
    [...new Matrix4().makeTranslation(origin.clone().negate()).multiply(matrix).transpose().elements].slice(0, 12);
  const expectSent = (changed: readonly number[]): void => {
    for (const i of changed) matrices.set(i, poses[i], origin);
    found.sent = 0;
    matrices.send();
    poses.forEach((each, i) => {
      const there = found.buffer.subarray(12 * i, 12 * i + 12);
      rowsOf(each).forEach((value, k) => expect(there[k], `number ${k} of object ${i}`).toBeCloseTo(value, 5));
    });
  };
  expectSent([0, 1, 2, 3, 4, 5, 6, 7]);
  for (const axis of ['x', 'y', 'z'] as const) {
    for (const i of [0, 4, 7]) {
      poses[i] = poses[i]
        .clone()
        .premultiply(new Matrix4().makeTranslation(new Vector3().setComponent('xyz'.indexOf(axis), 5)));
      expectSent([i]);
      expect(found.sent, `${axis} of object ${i}`).toBe(12);
    }
  }
  for (const i of [5, 2]) poses[i] = pose(i + 30);
  expectSent([5, 2]);
  expect(found.sent).toBe(4 * 12);
  expectSent([]);
  expect(found.sent).toBe(0);
  matrices.lose();
  expectSent([]);
});
