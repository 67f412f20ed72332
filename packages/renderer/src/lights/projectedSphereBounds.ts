import { projectionFar, projectionNear } from './projectionDepths';
import { halfChord, slopeBounds } from './slopeBounds';

const bounds = new Float64Array(4);

/**
 * Finds the rectangle on screen of the part of a sphere between near and far plane; exact, also with the camera inside
 * the sphere.
 * @param spheres - centre in view space (m) and radius (m, 0 to Infinity): 4 numbers at `at`. An array with an index
 * spares the engine four boxed numbers a call
 * @param projection - 16 elements, column-major: perspective (also off-centre, also without far plane) or orthographic
 * @param out - gets left, bottom, right, top in normalized device coordinates; they may lie outside of -1..1
 * @returns false, with `out` undefined, when the sphere is wholly outside of the frustum's planes
 * @see Mara and McGuire 2013, 2D Polyhedral Bounds of a Clipped, Perspective-Projected 3D Sphere
 */
export function projectedSphereBounds(
  spheres: ArrayLike<number>,
  at: number,
  projection: ArrayLike<number>,
  out: Float32Array | Float64Array | number[],
): boolean {
  const m = projection;
  const x = spheres[at];
  const y = spheres[at + 1];
  const z = spheres[at + 2];
  const radius = spheres[at + 3];
  const near = projectionNear(m);
  const far = projectionFar(m);
  if (!(radius - z >= near && -z - radius <= far)) return false;
  let left: number, right: number, bottom: number, top: number;
  if (m[11] === 0) {
    // with the centre beyond near or far plane, less than half of the sphere is left: no wider than its disc on the plane
    const reach = halfChord(-z < near ? near + z : Math.max(0, -z - far), radius);
    left = (x - reach) * m[0] + m[12];
    right = (x + reach) * m[0] + m[12];
    bottom = (y - reach) * m[5] + m[13];
    top = (y + reach) * m[5] + m[13];
  } else {
    slopeBounds(x, -z, radius, near, far, bounds);
    left = bounds[0] * m[0] - m[8];
    right = bounds[1] * m[0] - m[8];
    slopeBounds(y, -z, radius, near, far, bounds);
    bottom = bounds[0] * m[5] - m[9];
    top = bounds[1] * m[5] - m[9];
  }
  // a projection may mirror
  out[0] = Math.min(left, right);
  out[1] = Math.min(bottom, top);
  out[2] = Math.max(left, right);
  out[3] = Math.max(bottom, top);
  return out[0] <= 1 && out[2] >= -1 && out[1] <= 1 && out[3] >= -1;
}
