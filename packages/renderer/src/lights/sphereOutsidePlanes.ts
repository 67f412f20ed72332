/** True when a sphere lies wholly on the outer side of one of the six planes of `viewFrustumPlanes`. */
export function sphereOutsidePlanes(planes: Float64Array, x: number, y: number, z: number, radius: number): boolean {
  for (let i = 0; i < 24; i += 4) {
    if (planes[i] * x + planes[i + 1] * y + planes[i + 2] * z + planes[i + 3] < -radius) return true;
  }
  return false;
}
