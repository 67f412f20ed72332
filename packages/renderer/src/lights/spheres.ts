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

/** True when a sphere lies wholly on the outer side of one of the six planes of `viewFrustumPlanes`. */
export function sphereOutsidePlanes(planes: Float64Array, x: number, y: number, z: number, radius: number): boolean {
  for (let i = 0; i < 24; i += 4) {
    if (planes[i] * x + planes[i + 1] * y + planes[i + 2] * z + planes[i + 3] < -radius) return true;
  }
  return false;
}

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

/**
 * Smallest sphere round a cone with a spherical cap.
 * @param x - apex (m), with y and z
 * @param dx - unit axis from the apex into the cone, with dy and dz
 * @param range - length of the sides (m)
 * @param angle - half the opening (rad), 0 to π/2
 * @param out - gets centre and radius
 * @see Wronski 2017, Cull that cone
 */
export function coneBoundingSphere(
  x: number,
  y: number,
  z: number,
  dx: number,
  dy: number,
  dz: number,
  range: number,
  angle: number,
  out: Float64Array,
): Float64Array {
  const wide = angle > Math.PI / 4;
  const distance = wide ? range * Math.cos(angle) : range / (2 * Math.cos(angle));
  out[0] = x + dx * distance;
  out[1] = y + dy * distance;
  out[2] = z + dz * distance;
  out[3] = wide ? range * Math.sin(angle) : distance;
  return out;
}
