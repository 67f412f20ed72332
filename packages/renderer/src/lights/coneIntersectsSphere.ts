/**
 * Whether a cone with a spherical cap may touch a sphere; never false when it does.
 * Apex, unit axis into the cone, length (m), half angle (rad); sphere centre and radius (m).
 * @see Wronski 2017, Cull that cone
 */
export function coneIntersectsSphere(
  x: number, y: number, z: number, dx: number, dy: number, dz: number, range: number, angle: number,
  sx: number, sy: number, sz: number, radius: number,
): boolean {
  const vx = sx - x;
  const vy = sy - y;
  const vz = sz - z;
  const lengthSquared = vx * vx + vy * vy + vz * vz;
  const along = vx * dx + vy * dy + vz * dz;
  const closest = Math.cos(angle) * Math.sqrt(Math.max(0, lengthSquared - along * along)) - along * Math.sin(angle);
  return closest <= radius && along <= radius + range && along >= -radius;
}
