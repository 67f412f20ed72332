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

const low = new Float64Array(3);
const high = new Float64Array(3);

/**
 * Widens the parts of a cube map's faces so that they hold all directions from a point to a box.
 * @param parts of the six faces: least and most across, least and most up, as parts of the axis (-1 to 1 in a face), 4 numbers
 * each; nothing where least is more than most
 * @param boxes centre and half sizes (m), 6 numbers from index `at` on
 * @param wider by which they are wider to all sides (m)
 * @param range what lies farther from the point along an axis does not count (m)
 * @param widening how far a face reaches across, at least 1
 * @param writes false to leave the parts as they are
 * @returns whether they had to be widened
 */
export function cubeFaceParts(
  parts: Float64Array,
  boxes: Float64Array,
  at: number,
  wider: number,
  x: number,
  y: number,
  z: number,
  range: number,
  widening: number,
  writes = true,
): boolean {
  let widens = false;
  for (let i = 0; i < 3; i++) {
    const from = i === 0 ? x : i === 1 ? y : z;
    low[i] = Math.max(boxes[at + i] - boxes[at + 3 + i] - wider - from, -range);
    high[i] = Math.min(boxes[at + i] + boxes[at + 3 + i] + wider - from, range);
  }
  for (let i = 0; i < 6; i++) {
    const face = i * 6;
    const axis = FACES[face];
    const side = FACES[face + 1];
    // nearest and farthest along the axis of what the face sees of the box
    const farthest = side > 0 ? high[axis] : -low[axis];
    if (farthest <= 0) continue;
    const across = FACES[face + 2];
    const up = FACES[face + 4];
    const aside = Math.max(low[across], -high[across], low[up], -high[up], 0);
    const nearest = Math.max(side > 0 ? low[axis] : -high[axis], aside / widening, 1e-6 * farthest);
    if (nearest > farthest) continue;
    const moreAcross = widen(
      parts,
      i * 4,
      low[across],
      high[across],
      FACES[face + 3],
      nearest,
      farthest,
      widening,
      writes,
    );
    const moreUp = widen(parts, i * 4 + 2, low[up], high[up], FACES[face + 5], nearest, farthest, widening, writes);
    widens ||= moreAcross || moreUp;
    if (widens && !writes) return true;
  }
  return widens;
}

function widen(
  parts: Float64Array,
  at: number,
  least: number,
  most: number,
  side: number,
  nearest: number,
  farthest: number,
  widening: number,
  writes: boolean,
): boolean {
  const from = side > 0 ? least : -most;
  const to = side > 0 ? most : -least;
  // towards the middle what is farthest counts, away from it what is nearest
  const start = Math.max(-widening, from / (from > 0 ? farthest : nearest));
  const end = Math.min(widening, to / (to < 0 ? farthest : nearest));
  const widens = start < parts[at] || end > parts[at + 1];
  if (!widens || !writes) return widens;
  parts[at] = Math.min(parts[at], start);
  parts[at + 1] = Math.max(parts[at + 1], end);
  return true;
}
