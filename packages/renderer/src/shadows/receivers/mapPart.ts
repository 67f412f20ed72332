import type { Matrix4 } from 'three';
import type { Reach } from '../slots/reach';

/**
 * Widens the visible part of a map so that it holds a box as the map's camera projects it.
 * @param part - least and greatest x, least and greatest y, -1 to 1 in the map, 4 numbers from index `to` on
 * @param boxes - centre and half sizes (m), 6 numbers from index `at` on
 * @param reach - reach of the map, for its widening of boxes
 * @param matrix - from world to clip space
 * @param writes - false to leave the part as it is
 * @returns whether the part was too small
 */
export function mapPart(
  part: Float64Array,
  to: number,
  boxes: Float64Array,
  at: number,
  reach: Reach,
  { elements: e }: Matrix4,
  writes = true,
): boolean {
  const x = boxes[at];
  const y = boxes[at + 1];
  const z = boxes[at + 2];
  const wider = reach[5];
  const a = boxes[at + 3] + wider;
  const b = boxes[at + 4] + wider;
  const c = boxes[at + 5] + wider;
  const across = e[0] * x + e[4] * y + e[8] * z + e[12];
  const up = e[1] * x + e[5] * y + e[9] * z + e[13];
  const w = e[3] * x + e[7] * y + e[11] * z + e[15];
  if (!(w - Math.abs(e[3]) * a - Math.abs(e[7]) * b - Math.abs(e[11]) * c > 1e-6)) {
    // beside or behind the camera, a box may be anywhere in the map
    const isAll = part[to] === -Infinity;
    if (!isAll && writes) {
      part[to] = part[to + 2] = -Infinity;
      part[to + 1] = part[to + 3] = Infinity;
    }
    return !isAll;
  }
  let widens = false;
  for (let corner = 0; corner < 8; corner++) {
    const i = (corner & 1) === 0 ? a : -a;
    const j = (corner & 2) === 0 ? b : -b;
    const k = (corner & 4) === 0 ? c : -c;
    const scale = 1 / (w + e[3] * i + e[7] * j + e[11] * k);
    const u = (across + e[0] * i + e[4] * j + e[8] * k) * scale;
    const v = (up + e[1] * i + e[5] * j + e[9] * k) * scale;
    if (u >= part[to] && u <= part[to + 1] && v >= part[to + 2] && v <= part[to + 3]) continue;
    widens = true;
    if (!writes) break;
    part[to] = Math.min(part[to], u);
    part[to + 1] = Math.max(part[to + 1], u);
    part[to + 2] = Math.min(part[to + 2], v);
    part[to + 3] = Math.max(part[to + 3], v);
  }
  return widens;
}
