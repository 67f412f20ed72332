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
