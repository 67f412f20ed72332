/** Distances from the far end of depth that may be rounded to the end itself: some steps of 24 bits, and of 16. */
const STEPS_24 = 2 ** -22;
const STEPS_16 = 2 ** -14;
/** Far plane by near plane from which positions are no longer rebuilt from depth. */
const WIDEST = 5e4;

function isOblique(m: ArrayLike<number>): boolean {
  return m[2] !== 0 || m[6] !== 0;
}

/**
 * The distance (m, along the view) from which on a surface's depth may be 1, as that of an empty pixel; Infinity for
 * none.
 * @param m 16 elements of a projection, column-major
 * @param logarithmic the far plane of logarithmic depth (m), else 0
 * @param coarse depth has 16 bits
 */
export function farthestTold(m: ArrayLike<number>, reversed: boolean, logarithmic: number, coarse: boolean): number {
  if (isOblique(m)) return -Infinity;
  if (reversed) return Infinity;
  const step = 2 * (coarse ? STEPS_16 : STEPS_24);
  if (logarithmic > 0) return logarithmic * (1 - 32 * step);
  return m[11] === 0 ? (step + m[14] - 1) / m[10] : m[14] / (1 + m[10] - step);
}

/**
 * True if positions rebuilt from 32-bit depth would be too coarse or, with an oblique near plane, wrong: then the
 * G-buffer stores the distances of surfaces.
 * @param m 16 elements of a projection, column-major
 * @param precise depth is reversed or logarithmic
 */
export function needsStoredDistance(m: ArrayLike<number>, precise: boolean): boolean {
  if (isOblique(m)) return true;
  return m[11] !== 0 && !precise && !((m[10] - 1) / (m[10] + 1) <= WIDEST && m[10] < -1);
}
