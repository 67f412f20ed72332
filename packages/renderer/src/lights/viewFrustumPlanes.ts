/**
 * The six planes of a projection in view space, unit normals pointing inward, as 24 numbers (x, y, z, w each).
 * A point p is inside when dot(n, p) + w >= 0 for all. Perspective, orthographic and off-centre projections.
 * @param m - 16 elements, column-major, clip z in [-w, w]
 * @see Gribb and Hartmann 2001, Fast Extraction of Viewing Frustum Planes
 */
export function viewFrustumPlanes(m: ArrayLike<number>, out: Float64Array): Float64Array {
  for (let i = 0; i < 6; i++) {
    const row = i >> 1;
    const sign = i & 1 ? -1 : 1;
    const x = m[3] + sign * m[row];
    const y = m[7] + sign * m[row + 4];
    const z = m[11] + sign * m[row + 8];
    const w = m[15] + sign * m[row + 12];
    const length = Math.hypot(x, y, z) || 1;
    out[i * 4] = x / length;
    out[i * 4 + 1] = y / length;
    out[i * 4 + 2] = z / length;
    out[i * 4 + 3] = w / length;
  }
  return out;
}
