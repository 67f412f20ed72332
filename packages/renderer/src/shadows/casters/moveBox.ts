import type { Matrix4 } from 'three';

/**
 * Finds the box along the world's axes round a box in an object's own space; both as centre and half sizes (m), 6 numbers.
 * @param from - index of the first number in `boxes`
 * @param to - index of the first number in `out`
 */
export function moveBox(boxes: ArrayLike<number>, from: number, matrix: Matrix4, out: Float64Array, to: number): void {
  const e = matrix.elements;
  const x = boxes[from];
  const y = boxes[from + 1];
  const z = boxes[from + 2];
  const a = boxes[from + 3];
  const b = boxes[from + 4];
  const c = boxes[from + 5];
  for (let i = 0; i < 3; i++) {
    out[to + i] = e[i] * x + e[4 + i] * y + e[8 + i] * z + e[12 + i];
    out[to + 3 + i] = Math.abs(e[i]) * a + Math.abs(e[4 + i]) * b + Math.abs(e[8 + i]) * c;
  }
}
