/**
 * Space that a light's map covers, as an array, since engines may allocate fractional arguments on the heap.
 *
 * | index | holds |
 * |---|---|
 * | 0–2 | position of the light (world space, m) |
 * | 3 | range of the light (m), Infinity for none |
 * | 4 | tangent of half the angle that a face of a cube shows, at least 1 |
 * | 5 | widening of boxes, to all sides (m) |
 */
export type Reach = Float64Array;

export function makeReach(x = 0, y = 0, z = 0, range = Infinity, widening = 1, wider = 0): Reach {
  return new Float64Array([x, y, z, range, widening, wider]);
}

/** @param matrixWorld - elements of the world matrix of one of the map's cameras */
export function setReach(
  reach: Reach,
  matrixWorld: readonly number[],
  range: number,
  widening: number,
  wider: number,
): void {
  reach[0] = matrixWorld[12];
  reach[1] = matrixWorld[13];
  reach[2] = matrixWorld[14];
  reach[3] = range;
  reach[4] = widening;
  reach[5] = wider;
}

/** True when no part of a box (centre and half sizes, m, from index `at` on) is within range. */
export function isBeyond(reach: Reach, boxes: Float64Array, at: number): boolean {
  const dx = Math.max(0, Math.abs(reach[0] - boxes[at]) - boxes[at + 3]);
  const dy = Math.max(0, Math.abs(reach[1] - boxes[at + 1]) - boxes[at + 4]);
  const dz = Math.max(0, Math.abs(reach[2] - boxes[at + 2]) - boxes[at + 5]);
  return dx * dx + dy * dy + dz * dz > reach[3] * reach[3];
}

/** True when all of a box (centre and half sizes, m, from index `at` on) is within range. */
export function isWithin(reach: Reach, boxes: Float64Array, at: number): boolean {
  const x = Math.abs(reach[0] - boxes[at]) + boxes[at + 3];
  const y = Math.abs(reach[1] - boxes[at + 1]) + boxes[at + 4];
  const z = Math.abs(reach[2] - boxes[at + 2]) + boxes[at + 5];
  return x * x + y * y + z * z <= reach[3] * reach[3];
}
