import type { Reach } from './reach';

/**
 * Finds the faces of a cube map that show some of a box within range: bits 0 to 5 for +x, -x, +y, -y, +z, -z.
 * @param boxes - centre and half sizes (m), 6 numbers from index `at` on
 * @param reach - reach of the map: place and range of the light, and widening of its faces
 */
export function cubeFacesOf(boxes: Float64Array, at: number, reach: Reach): number {
  const x = boxes[at] - reach[0];
  const y = boxes[at + 1] - reach[1];
  const z = boxes[at + 2] - reach[2];
  const range = reach[3];
  const widening = reach[4];
  const wider = reach[5];
  const hx = boxes[at + 3] + wider;
  const hy = boxes[at + 4] + wider;
  const hz = boxes[at + 5] + wider;
  // distance of the box from the light on each axis, 0 where it spans the light; without branches, here and below, since they
  // are unpredictable
  const gapX = Math.abs(x) - hx;
  const gapY = Math.abs(y) - hy;
  const gapZ = Math.abs(z) - hz;
  const awayX = 0.5 * (gapX + Math.abs(gapX));
  const awayY = 0.5 * (gapY + Math.abs(gapY));
  const awayZ = 0.5 * (gapZ + Math.abs(gapZ));
  if (awayX * awayX + awayY * awayY + awayZ * awayZ > range * range) return 0;
  // a face shows points whose sideways distance is at most their distance along its axis times the widening
  const right = widening * (hx + x);
  const left = widening * (hx - x);
  const top = widening * (hy + y);
  const bottom = widening * (hy - y);
  const front = widening * (hz + z);
  const back = widening * (hz - z);
  return (
    (+(awayY <= right) & +(awayZ <= right)) |
    ((+(awayY <= left) & +(awayZ <= left)) << 1) |
    ((+(awayX <= top) & +(awayZ <= top)) << 2) |
    ((+(awayX <= bottom) & +(awayZ <= bottom)) << 3) |
    ((+(awayX <= front) & +(awayY <= front)) << 4) |
    ((+(awayX <= back) & +(awayY <= back)) << 5)
  );
}
