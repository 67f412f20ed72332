/**
 * What a light's map looks at, in an array: a number that one function hands to another may cost an object.
 *
 * | index | holds |
 * |---|---|
 * | 0–2 | where it looks from (m) |
 * | 3 | range beyond which nothing counts (m), Infinity for none |
 * | 4 | tangent of half the angle that a face of a cube sees, at least 1 |
 * | 5 | by which boxes are taken to be wider to all sides (m) |
 */
export type Reach = Float64Array;

export function makeReach(x = 0, y = 0, z = 0, range = Infinity, widening = 1, wider = 0): Reach {
  return new Float64Array([x, y, z, range, widening, wider]);
}

/** @param place matrix of a camera that looks from there, its elements */
export function setReach(reach: Reach, place: readonly number[], range: number, widening: number, wider: number): void {
  reach[0] = place[12];
  reach[1] = place[13];
  reach[2] = place[14];
  reach[3] = range;
  reach[4] = widening;
  reach[5] = wider;
}

/** True when no part of a box (centre and half sizes, m, from index `at` on) is within the range. */
export function isBeyond(reach: Reach, boxes: Float64Array, at: number): boolean {
  const dx = Math.max(0, Math.abs(reach[0] - boxes[at]) - boxes[at + 3]);
  const dy = Math.max(0, Math.abs(reach[1] - boxes[at + 1]) - boxes[at + 4]);
  const dz = Math.max(0, Math.abs(reach[2] - boxes[at + 2]) - boxes[at + 5]);
  return dx * dx + dy * dy + dz * dz > reach[3] * reach[3];
}

/** True when all of a box is within the range. */
export function isWithin(reach: Reach, boxes: Float64Array, at: number): boolean {
  const x = Math.abs(reach[0] - boxes[at]) + boxes[at + 3];
  const y = Math.abs(reach[1] - boxes[at + 1]) + boxes[at + 4];
  const z = Math.abs(reach[2] - boxes[at + 2]) + boxes[at + 5];
  return x * x + y * y + z * z <= reach[3] * reach[3];
}
