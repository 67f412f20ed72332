import type { Reach } from '../reach';

/** Of each face, +x, -x, +y, -y, +z, -z: its axis and side, and the axes and sides across and up, as farol_cubeFace has them. */
// prettier-ignore
const FACES = new Int8Array([
  0, 1, 2, 1, 1, 1,
  0, -1, 2, -1, 1, 1,
  1, 1, 0, 1, 2, 1,
  1, -1, 0, -1, 2, 1,
  2, 1, 0, -1, 1, 1,
  2, -1, 0, 1, 1, 1,
]);

/** By which a part may be wider than need be, for less work (parts of the axis). */
const SLACK = 0.06;

const low = new Float64Array(3);
const high = new Float64Array(3);
/** Nearest and farthest along the axis of what a face sees of a box. */
const along = new Float64Array(2);

/**
 * Widens the parts of a cube map's faces so that they hold all directions from a point to a box.
 * @param parts of the six faces: least and most across, least and most up, as parts of the axis (-1 to 1 in a face), 4 numbers
 * each; nothing where least is more than most
 * @param boxes centre and half sizes (m), 6 numbers from index `at` on
 * @param reach of the map; what lies farther from the point along an axis than its range does not count
 * @param writes false to leave the parts as they are
 * @returns 0 where they hold the box already, 1 where they have to be widened by no more than `SLACK`, else 2
 */
export function cubeFaceParts(
  parts: Float64Array,
  boxes: Float64Array,
  at: number,
  reach: Reach,
  writes = true,
): number {
  const range = reach[3];
  const widening = reach[4];
  const wider = reach[5];
  for (let i = 0; i < 3; i++) {
    low[i] = Math.max(boxes[at + i] - boxes[at + 3 + i] - wider - reach[i], -range);
    high[i] = Math.min(boxes[at + i] + boxes[at + 3 + i] + wider - reach[i], range);
  }
  let widens = 0;
  for (let i = 0; i < 6; i++) {
    const face = i * 6;
    const axis = FACES[face];
    const side = FACES[face + 1];
    const farthest = side > 0 ? high[axis] : -low[axis];
    if (farthest <= 0) continue;
    const across = FACES[face + 2];
    const up = FACES[face + 4];
    const aside = Math.max(low[across], -high[across], low[up], -high[up], 0);
    const nearest = Math.max(side > 0 ? low[axis] : -high[axis], aside / widening, 1e-6 * farthest);
    if (nearest > farthest) continue;
    along[0] = nearest;
    along[1] = farthest;
    const moreAcross = widen(parts, i * 4, across, FACES[face + 3], reach, writes);
    const moreUp = widen(parts, i * 4 + 2, up, FACES[face + 5], reach, writes);
    widens = Math.max(widens, moreAcross, moreUp);
    if (widens === 2 && !writes) return 2;
  }
  return widens;
}

/**
 * @param axis of the box that lies across, or up
 * @param side which way
 */
function widen(parts: Float64Array, at: number, axis: number, side: number, reach: Reach, writes: boolean): number {
  const from = side > 0 ? low[axis] : -high[axis];
  const to = side > 0 ? high[axis] : -low[axis];
  const widening = reach[4];
  // towards the middle what is farthest counts, away from it what is nearest
  const start = Math.max(-widening, from / (from > 0 ? along[1] : along[0]));
  const end = Math.min(widening, to / (to < 0 ? along[1] : along[0]));
  if (start >= parts[at] && end <= parts[at + 1]) return 0;
  const widens = start >= parts[at] - SLACK && end <= parts[at + 1] + SLACK ? 1 : 2;
  if (writes) {
    parts[at] = Math.min(parts[at], start);
    parts[at + 1] = Math.max(parts[at + 1], end);
  }
  return widens;
}
