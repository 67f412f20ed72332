/**
 * Depth of the near plane (m before the camera; an orthographic one may be below 0). For oblique planes, as in three's
 * mirrors, a depth that is surely before the near plane.
 * @param m - 16 elements of a projection, column-major, clip z in [-w, w], or reversed, near to far, in [w, 0]
 */
export function projectionNear(m: ArrayLike<number>): number {
  const orthographic = m[11] === 0;
  if (m[2] !== 0 || m[6] !== 0) return orthographic ? -Infinity : 1e-6;
  if (isReversed(m)) return orthographic ? (m[14] - 1) / m[10] : m[14] / (m[10] + 1);
  return orthographic ? (m[14] + 1) / m[10] : m[14] / (m[10] - 1);
}

/** Depth of the far plane (m); Infinity if there is none or it is oblique. */
export function projectionFar(m: ArrayLike<number>): number {
  if (m[2] !== 0 || m[6] !== 0) return Infinity;
  if (isReversed(m)) return m[10] > 0 ? m[14] / m[10] : Infinity;
  if (m[11] === 0) return (m[14] - 1) / m[10];
  return m[10] < -1 ? m[14] / (m[10] + 1) : Infinity;
}

/** three's reversed depth: then alone clip z grows with view z. */
function isReversed(m: ArrayLike<number>): boolean {
  return m[10] >= 0;
}
