/** Distances from the far end of depth (1) within which depth may be rounded to 1, if stored in 24 bits, in 16 bits. */
const STEPS_24 = 2 ** -22;
const STEPS_16 = 2 ** -14;
/** Ratio of far to near plane from which on positions are not computed from depth. */
const WIDEST = 5e4;

/** Ratio of depth range to height of an orthographic view from which on single steps of depth are visible. */
const DEEPEST = 1e3;

/**
 * Whether positions can be computed from depth, and lights sorted into tiles: the projection is perspective or orthographic,
 * possibly off-centre or with an oblique near plane, but not skewed, and does not include the view matrix, as in mapping
 * libraries.
 * @param m - 16 elements of a projection, column-major
 * @param orthographic - whether the camera is an OrthographicCamera
 */
export function isPlainProjection(m: ArrayLike<number>, orthographic: boolean): boolean {
  if (m[1] || m[3] || m[4] || m[7] || m[15] !== +orthographic) return false;
  return orthographic ? !m[8] && !m[9] && !m[11] : m[11] === -1 && !m[12] && !m[13];
}

function isOblique(m: ArrayLike<number>): boolean {
  return m[2] !== 0 || m[6] !== 0;
}

/**
 * Distance (m, along the view) from which on a surface's depth may be 1, like an empty pixel's; Infinity if never.
 * @param m - 16 elements of a projection, column-major
 * @param logarithmic - far plane of logarithmic depth (m), else 0
 * @param coarse - whether depth has 16 bits
 */
export function farthestTold(m: ArrayLike<number>, reversed: boolean, logarithmic: number, coarse: boolean): number {
  if (isOblique(m)) return -Infinity;
  if (reversed) return Infinity;
  const step = 2 * (coarse ? STEPS_16 : STEPS_24);
  if (logarithmic > 0) return logarithmic * (1 - 32 * step);
  return m[11] === 0 ? (step + m[14] - 1) / m[10] : m[14] / (1 + m[10] - step);
}

/**
 * True if positions computed from 32-bit depth would be too coarse or, with an oblique near plane, wrong: the G-buffer then
 * stores the distances of surfaces.
 * @param m - 16 elements of a projection, column-major
 * @param precise - whether depth is reversed or logarithmic
 */
export function needsStoredDistance(m: ArrayLike<number>, precise: boolean): boolean {
  if (isOblique(m)) return true;
  if (m[11] === 0) return Math.abs(m[5]) > DEEPEST * Math.abs(m[10]);
  return !precise && !((m[10] - 1) / (m[10] + 1) <= WIDEST && m[10] < -1);
}
