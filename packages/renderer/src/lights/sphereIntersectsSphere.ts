/** Whether two spheres touch: centres and radii in metres. */
export function sphereIntersectsSphere(
  ax: number,
  ay: number,
  az: number,
  ar: number,
  bx: number,
  by: number,
  bz: number,
  br: number,
): boolean {
  const x = ax - bx;
  const y = ay - by;
  const z = az - bz;
  const reach = ar + br;
  return x * x + y * y + z * z <= reach * reach;
}
