/**
 * Extent of a cone with a spherical cap from its apex along a direction: the greatest `dot(p - apex, u)`.
 * @param cosine - between the axis and the unit vector u
 * @param angle - half the opening (rad), 0 to π/2
 */
export function coneSupport(cosine: number, range: number, angle: number): number {
  const beyond = Math.acos(Math.min(1, Math.max(-1, cosine))) - angle;
  return beyond <= 0 ? range : Math.max(0, range * Math.cos(beyond));
}
