/**
 * Extent of a cone with a spherical cap from its apex along a unit vector u: the greatest `dot(p - apex, u)`.
 * @param cosine - cosine between the axis and u
 * @param angle - half the opening (rad), 0 to π/2
 */
export function coneSupport(cosine: number, range: number, angle: number): number {
  const beyond = Math.acos(Math.min(1, Math.max(-1, cosine))) - angle;
  return beyond <= 0 ? range : Math.max(0, range * Math.cos(beyond));
}

/**
 * Whether a cone with a spherical cap and a sphere touch; exact. Takes arrays and indices, since engines may box number
 * arguments.
 * @param apexes - apex (m) and length of the sides, which is also the radius of the cap (m): 4 numbers at `cone`
 * @param axes - unit axis from the cone to its apex, and cosine of half the opening (0 to π/2): 4 numbers at `cone`
 * @param spheres - centre and radius (m): 4 numbers at `sphere`
 * @see Quilez, 3D SDF primitives (solid angle), https://iquilezles.org/articles/distfunctions/
 */
export function coneIntersectsSphere(
  apexes: ArrayLike<number>,
  axes: ArrayLike<number>,
  cone: number,
  spheres: ArrayLike<number>,
  sphere: number,
): boolean {
  const range = apexes[cone + 3];
  const radius = spheres[sphere + 3];
  const cosine = axes[cone + 3];
  const sine = Math.sqrt(Math.max(0, 1 - cosine * cosine));
  const vx = spheres[sphere] - apexes[cone];
  const vy = spheres[sphere + 1] - apexes[cone + 1];
  const vz = spheres[sphere + 2] - apexes[cone + 2];
  const squared = vx * vx + vy * vy + vz * vz;
  if (squared > (range + radius) * (range + radius)) return false;
  // coordinates of the sphere's centre along the cone's axis and across it
  const along = -(vx * axes[cone] + vy * axes[cone + 1] + vz * axes[cone + 2]);
  const across = Math.sqrt(Math.max(0, squared - along * along));
  if (across * cosine <= along * sine) return true;
  // for a centre beside the cone, the nearest point of the cone's side
  const t = Math.min(range, Math.max(0, across * sine + along * cosine));
  const beside = across - t * sine;
  const before = along - t * cosine;
  return beside * beside + before * before <= radius * radius;
}
