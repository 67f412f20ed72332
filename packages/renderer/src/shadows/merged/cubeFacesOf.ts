import type { Reach } from '../reach';

/**
 * Which faces of a cube map round a point see some of a box: bits 0 to 5 for +x, -x, +y, -y, +z, -z.
 * @param boxes centre and half sizes (m), 6 numbers from index `at` on
 * @param reach of the map: the point, and how far a face sees across
 */
export function cubeFacesOf(boxes: Float64Array, at: number, reach: Reach): number {
  const dx = boxes[at] - reach[0];
  const dy = boxes[at + 1] - reach[1];
  const dz = boxes[at + 2] - reach[2];
  const widening = reach[4];
  const hx = boxes[at + 3];
  const hy = boxes[at + 4];
  const hz = boxes[at + 5];
  // least that an axis lacks of the others: a face is seen where |a| and |b| are within its axis times the widening
  const lackX = Math.abs(dx) - hx;
  const lackY = Math.abs(dy) - hy;
  const lackZ = Math.abs(dz) - hz;
  const plusX = widening * (dx + hx);
  const minusX = widening * (hx - dx);
  const plusY = widening * (dy + hy);
  const minusY = widening * (hy - dy);
  const plusZ = widening * (dz + hz);
  const minusZ = widening * (hz - dz);
  return (
    (plusX >= 0 && lackY <= plusX && lackZ <= plusX ? 1 : 0) |
    (minusX >= 0 && lackY <= minusX && lackZ <= minusX ? 2 : 0) |
    (plusY >= 0 && lackX <= plusY && lackZ <= plusY ? 4 : 0) |
    (minusY >= 0 && lackX <= minusY && lackZ <= minusY ? 8 : 0) |
    (plusZ >= 0 && lackX <= plusZ && lackY <= plusZ ? 16 : 0) |
    (minusZ >= 0 && lackX <= minusZ && lackY <= minusZ ? 32 : 0)
  );
}
