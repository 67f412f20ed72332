/**
 * Whether a cone with a spherical cap and a sphere touch; exact.
 * @param x apex (m), with y and z
 * @param dx unit axis from the apex into the cone, with dy and dz
 * @param range length of the sides, and radius of the cap (m)
 * @param angle half the opening (rad), 0 to π/2
 * @param sx centre of the sphere (m), with sy, sz and radius
 * @see Quilez, 3D SDF primitives (solid angle), https://iquilezles.org/articles/distfunctions/
 */
export function coneIntersectsSphere(
  x: number,
  y: number,
  z: number,
  dx: number,
  dy: number,
  dz: number,
  range: number,
  angle: number,
  sx: number,
  sy: number,
  sz: number,
  radius: number,
): boolean {
  const vx = sx - x;
  const vy = sy - y;
  const vz = sz - z;
  const squared = vx * vx + vy * vy + vz * vz;
  if (squared > (range + radius) * (range + radius)) return false;
  // in the plane of axis and centre
  const along = vx * dx + vy * dy + vz * dz;
  const across = Math.sqrt(Math.max(0, squared - along * along));
  const cosine = Math.cos(angle);
  const sine = Math.sin(angle);
  if (across * cosine <= along * sine) return true;
  // beside the cone: the distance to its side
  const t = Math.min(range, Math.max(0, across * sine + along * cosine));
  const beside = across - t * sine;
  const before = along - t * cosine;
  return beside * beside + before * before <= radius * radius;
}
