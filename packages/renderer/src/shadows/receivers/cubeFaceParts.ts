import { cubeFacesOf } from '../slots/cubeFacesOf';
import type { Reach } from '../slots/reach';

/**
 * Direction to the right in each face of a cube map (+x, -x, +y, -y, +z, -z), as an index into that list; as farol_cubeFace in
 * lightShadow.glsl.
 */
const ACROSS = new Uint8Array([4, 5, 0, 1, 1, 0]);
const UP = new Uint8Array([2, 2, 4, 4, 2, 2]);

/**
 * Excess width of a face's visible part that is accepted, to save work (1: the distance from centre to edge of a face).
 */
const SLACK = 0.06;

/** Margin added to the visible parts, so that they cover their boxes after rounding. */
const ROUNDING = 1e-12;

/** Extent of a box, clipped to the range, in each of the six directions (m). */
const ends = new Float64Array(6);

/**
 * Widens the visible parts of a cube map's faces so that they hold all directions from the light to a box within range.
 * @param parts - extents of the six faces' parts left, right, down and up, divided by the distance along the face's axis, 4
 *   numbers each; -Infinity for nothing, Infinity for all
 * @param boxes - centre and half sizes (m), 6 numbers from index `at` on
 * @param reach - reach of the map: the light's position and range
 * @param open - faces whose part does not cover the face yet, as bits; others are skipped
 * @param writes - false to leave the parts as they are
 * @returns 0 if the parts hold the box already, 1 if they are too small by no more than `SLACK`, else 2
 */
export function cubeFaceParts(
  parts: Float64Array,
  boxes: Float64Array,
  at: number,
  reach: Reach,
  open = 63,
  writes = true,
): number {
  let faces = open & cubeFacesOf(boxes, at, reach);
  if (faces === 0) return 0;
  const range = reach[3];
  const widening = reach[4];
  for (let i = 0; i < 3; i++) {
    const from = boxes[at + i] - reach[i];
    const half = boxes[at + 3 + i] + reach[5];
    const end = from + half;
    const other = half - from;
    ends[i * 2] = end < range ? end : range;
    ends[i * 2 + 1] = other < range ? other : range;
  }
  let widens = 0;
  while (faces !== 0) {
    const face = 31 - Math.clz32(faces);
    faces ^= 1 << face;
    const across = ACROSS[face];
    const up = UP[face];
    const right = ends[across];
    const left = ends[across ^ 1];
    const top = ends[up];
    const bottom = ends[up ^ 1];
    // distances of the box along the axis of the face
    const farthest = ends[face];
    const aside = -minimum(minimum(left, right), minimum(bottom, top)) / widening;
    const nearest = -minimum(minimum(ends[face ^ 1], -aside), -1e-6 * farthest);
    if (nearest > farthest) continue;
    const first = face * 4;
    // ends below 0, short of the face's middle, count at the greatest distance, others at the least: both save a branch
    const isWithin =
      +(left <= parts[first] * nearest) &
      +(left <= parts[first] * farthest) &
      +(right <= parts[first + 1] * nearest) &
      +(right <= parts[first + 1] * farthest) &
      +(bottom <= parts[first + 2] * nearest) &
      +(bottom <= parts[first + 2] * farthest) &
      +(top <= parts[first + 3] * nearest) &
      +(top <= parts[first + 3] * farthest);
    if (isWithin !== 0) continue;
    widens = 1;
    for (let side = first; side < first + 4; side++) {
      const end = ends[(side < first + 2 ? across : up) ^ (~side & 1)];
      const depth = end < 0 ? farthest : nearest;
      const part = parts[side];
      if (end <= part * depth) continue;
      if (writes) parts[side] = end < widening * depth ? end / depth + ROUNDING : Infinity;
      else if (part + SLACK < widening && end > (part + SLACK) * depth) return 2;
    }
  }
  return widens;
}

/** Faces that their part does not cover wholly, as bits. */
export function openFaces(parts: Float64Array): number {
  let open = 0;
  for (let side = 0; side < 24; side++) if (parts[side] !== Infinity) open |= 1 << (side >> 2);
  return open;
}

/** Lesser of two finite numbers; without a branch, see `cubeFacesOf`. */
function minimum(a: number, b: number): number {
  return 0.5 * (a + b - Math.abs(a - b));
}
