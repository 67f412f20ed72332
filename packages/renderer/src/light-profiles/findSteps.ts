import type { PhotometricData } from './PhotometricData';

/** Possible steps between texels (degrees), the widest first. */
const STEPS = [90, 45, 30, 22.5, 20, 18, 15, 12, 10, 9, 7.5, 6, 5, 4, 3, 2.5, 2, 1, 0.5];
const FINEST = 0.25;
/** Step (degrees) if the light stops abruptly at the first or last angle; also for types A and B, whose axes differ. */
const FINE = 0.5;

/**
 * Size of a profile's texture (texels): the smallest whose angles include the file's, so that values are interpolated as in the
 * file.
 */
export function findSteps(data: PhotometricData): { columns: number; rows: number } {
  const { type, verticalAngles: v, horizontalAngles: h } = data;
  if (type !== 'C') return { columns: 180 / FINE + 1, rows: 360 / FINE };
  let vertical = widestStep(v);
  if (endsLit(data)) vertical = Math.min(vertical, FINE);
  const rows = h.length === 1 ? 1 : Math.round(360 / widestStep(h));
  return { columns: Math.round(180 / vertical) + 1, rows };
}

function widestStep(angles: Float64Array): number {
  return STEPS.find((step) => angles.every((angle) => isMultiple(angle, step))) ?? FINEST;
}

function isMultiple(angle: number, step: number): boolean {
  return Math.abs(angle / step - Math.round(angle / step)) < 1e-6;
}

/** Whether there is light at the first or last vertical angle, and none beyond. */
function endsLit({ verticalAngles: v, horizontalAngles: h, candelas }: PhotometricData): boolean {
  const last = v.length - 1;
  for (let plane = 0; plane < h.length; plane++) {
    const at = plane * v.length;
    if ((v[0] > 0 && candelas[at] > 0) || (v[last] < 180 && candelas[at + last] > 0)) return true;
  }
  return false;
}
