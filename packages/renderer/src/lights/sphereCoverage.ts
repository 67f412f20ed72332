/**
 * Share of the picture that a sphere covers, roughly, 0 to 1.
 * @param depth - of its centre before the camera (m)
 * @param radius - (m)
 * @param projection - 16 elements, column-major
 */
export function sphereCoverage(depth: number, radius: number, projection: ArrayLike<number>): number {
  const p = projection;
  const scale = p[11] === 0 ? radius : radius / Math.max(depth, radius);
  return Math.min(1, (Math.PI / 4) * scale * scale * Math.abs(p[0] * p[5]));
}
