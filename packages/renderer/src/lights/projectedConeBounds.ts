import { coneBoundingSphere } from './coneBoundingSphere';
import { coneSupport } from './coneSupport';
import { projectedSphereBounds } from './projectedSphereBounds';
import { projectionFar, projectionNear } from './projectionDepths';
import { slopeBounds } from './slopeBounds';

const sphere = new Float64Array(4);
const rectangle = new Float64Array(4);
const slopes = new Float64Array(2);
const tangents = new Float64Array(4);

/**
 * Finds the rectangle on screen of a spot light's cone, which ends in a spherical cap. Exact for a cone wholly beyond
 * the near plane; else the intersection of the rectangles of two bounding spheres.
 * @param x - apex in view space (m), with y and z
 * @param dx - unit axis from the apex into the cone, with dy and dz
 * @param range - (m), finite
 * @param angle - half the opening (rad), 0 to π/2
 * @param projection - 16 elements, column-major, as for `projectedSphereBounds`
 * @param out - gets left, bottom, right, top in normalized device coordinates; they may lie outside of -1..1
 * @returns false, with `out` undefined, when the cone is surely outside of the frustum's planes
 */
export function projectedConeBounds(
  x: number,
  y: number,
  z: number,
  dx: number,
  dy: number,
  dz: number,
  range: number,
  angle: number,
  projection: ArrayLike<number>,
  out: Float32Array | Float64Array | number[],
): boolean {
  const m = projection;
  const near = projectionNear(m);
  const nearest = -z - coneSupport(dz, range, angle);
  const farthest = -z + coneSupport(-dz, range, angle);
  if (!(farthest >= near && nearest <= projectionFar(m))) return false;
  coneBoundingSphere(x, y, z, dx, dy, dz, range, angle, sphere);
  if (!projectedSphereBounds(sphere, 0, m, rectangle)) return false;
  sphere[0] = x;
  sphere[1] = y;
  sphere[2] = z;
  sphere[3] = range;
  if (!projectedSphereBounds(sphere, 0, m, out)) return false;
  if (m[11] === 0) {
    intersect(
      0,
      (x - coneSupport(-dx, range, angle)) * m[0] + m[12],
      (x + coneSupport(dx, range, angle)) * m[0] + m[12],
    );
    intersect(
      1,
      (y - coneSupport(-dy, range, angle)) * m[5] + m[13],
      (y + coneSupport(dy, range, angle)) * m[5] + m[13],
    );
  } else if (nearest >= near) {
    coneSlopes(x, -z, dx, -dz, range, angle);
    intersect(0, slopes[0] * m[0] - m[8], slopes[1] * m[0] - m[8]);
    coneSlopes(y, -z, dy, -dz, range, angle);
    intersect(1, slopes[0] * m[5] - m[9], slopes[1] * m[5] - m[9]);
  }
  out[0] = Math.max(out[0], rectangle[0]);
  out[1] = Math.max(out[1], rectangle[1]);
  out[2] = Math.min(out[2], rectangle[2]);
  out[3] = Math.min(out[3], rectangle[3]);
  return out[0] <= 1 && out[2] >= -1 && out[1] <= 1 && out[3] >= -1;
}

function intersect(axis: 0 | 1, a: number, b: number): void {
  rectangle[axis] = Math.max(rectangle[axis], Math.min(a, b));
  rectangle[axis + 2] = Math.min(rectangle[axis + 2], Math.max(a, b));
}

/**
 * Least and greatest slope of a cone wholly before the eye: a tangent touches the apex, the rim of the cap, or the cap.
 * @param lateral - apex (m), with depth; the axis by its parts in the same plane
 */
function coneSlopes(
  lateral: number,
  depth: number,
  axisLateral: number,
  axisDepth: number,
  range: number,
  angle: number,
): void {
  const apex = lateral / depth;
  slopes[0] = apex;
  slopes[1] = apex;
  const cosine = Math.cos(angle);
  const rim = range * Math.sin(angle);
  const c = lateral + axisLateral * range * cosine;
  const d = depth + axisDepth * range * cosine;
  // (c - t d)² = rim² |(1, -t) less its part along the axis|²
  const a2 = d * d - rim * rim * (1 - axisDepth * axisDepth);
  const a1 = c * d + rim * rim * axisLateral * axisDepth;
  const a0 = c * c - rim * rim * (1 - axisLateral * axisLateral);
  const root = Math.sqrt(Math.max(0, a1 * a1 - a2 * a0));
  slopes[0] = Math.min(slopes[0], (a1 - root) / a2);
  slopes[1] = Math.max(slopes[1], (a1 + root) / a2);
  slopeBounds(lateral, depth, range, Number.MIN_VALUE, Infinity, tangents);
  for (let i = 0; i < 2; i++) {
    const touch = tangents[2 + i];
    if (touch <= 0) continue;
    const along = (tangents[i] * touch - lateral) * axisLateral + (touch - depth) * axisDepth;
    if (along >= cosine * range)
      slopes[i] = i === 0 ? Math.min(slopes[0], tangents[0]) : Math.max(slopes[1], tangents[1]);
  }
}
