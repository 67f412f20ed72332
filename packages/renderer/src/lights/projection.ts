import { coneBoundingSphere } from './spheres';
import { coneSupport } from './cones';

/**
 * Depth of the near plane (m before the camera; an orthographic one may be below 0). For oblique planes, as in three's mirrors,
 * a depth certainly in front of the plane.
 * @param m - 16 elements of a projection, column-major, clip z in [-w, w], or reversed, near to far, in [w, 0]
 */
export function projectionNear(m: ArrayLike<number>): number {
  const orthographic = m[11] === 0;
  if (m[2] !== 0 || m[6] !== 0) return orthographic ? -Infinity : 1e-6;
  if (isReversed(m)) return orthographic ? (m[14] - 1) / m[10] : m[14] / (m[10] + 1);
  return orthographic ? (m[14] + 1) / m[10] : m[14] / (m[10] - 1);
}

/** Depth of the far plane (m), Infinity where there is none or it is oblique. */
export function projectionFar(m: ArrayLike<number>): number {
  if (m[2] !== 0 || m[6] !== 0) return Infinity;
  if (isReversed(m)) return m[10] > 0 ? m[14] / m[10] : Infinity;
  if (m[11] === 0) return (m[14] - 1) / m[10];
  return m[10] < -1 ? m[14] / (m[10] + 1) : Infinity;
}

/** Whether depth is reversed: only then clip z grows with view z. */
function isReversed(m: ArrayLike<number>): boolean {
  return m[10] >= 0;
}

/**
 * Smallest and largest slope `lateral / depth`, seen from the origin, of a disc between two depths. The disc must reach into
 * that range, and `near` must be above 0.
 * @param lateral - centre (m), with depth
 * @param out - receives least and greatest slope, then the depths (m) at which the tangents touch the whole disc; 0 or less for
 *   none before the eye
 * @see Mara and McGuire 2013, 2D Polyhedral Bounds of a Clipped, Perspective-Projected 3D Sphere
 */
export function slopeBounds(
  lateral: number,
  depth: number,
  radius: number,
  near: number,
  far: number,
  out: Float64Array,
): void {
  const squared = lateral * lateral + depth * depth;
  const tangentSquared = squared - radius * radius;
  out[2] = 0;
  out[3] = 0;
  if (tangentSquared > 0) {
    const tangent = Math.sqrt(tangentSquared);
    const scale = tangent / squared;
    const low = depth * tangent + lateral * radius;
    const high = depth * tangent - lateral * radius;
    out[0] = (lateral * tangent - depth * radius) / low;
    out[1] = (lateral * tangent + depth * radius) / high;
    out[2] = low * scale;
    out[3] = high * scale;
  }
  // if a tangent touches outside of the range, the end of the chord at the range's limit is the bound
  if (!(out[2] >= near)) out[0] = (lateral - halfChord(depth - near, radius)) / near;
  else if (out[2] > far) out[0] = (lateral - halfChord(depth - far, radius)) / far;
  if (!(out[3] >= near)) out[1] = (lateral + halfChord(depth - near, radius)) / near;
  else if (out[3] > far) out[1] = (lateral + halfChord(depth - far, radius)) / far;
}

/** Half the width of a disc at a distance from its centre; 0 outside of it. */
export function halfChord(distance: number, radius: number): number {
  return radius === Infinity ? Infinity : Math.sqrt(Math.max(0, radius * radius - distance * distance));
}

const bounds = new Float64Array(4);

/**
 * The rectangle on screen of the part of a sphere between near and far plane; exact, also with the camera inside the sphere.
 * @param spheres - centre in view space (m) and radius (m, 0 to Infinity): 4 numbers at `at`. An array and an index, since
 *   engines may box number arguments
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
    // with the centre beyond near or far plane, less than half of the sphere is left, no wider than its disc on the plane
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
  // a mirroring projection swaps left and right
  out[0] = Math.min(left, right);
  out[1] = Math.min(bottom, top);
  out[2] = Math.max(left, right);
  out[3] = Math.max(bottom, top);
  return out[0] <= 1 && out[2] >= -1 && out[1] <= 1 && out[3] >= -1;
}

const sphere = new Float64Array(4);
const rectangle = new Float64Array(4);
const slopes = new Float64Array(2);
const tangents = new Float64Array(4);

/**
 * The rectangle on screen of a spot light's cone, which ends in a cap of its range's sphere. Exact for the whole cone if it lies
 * beyond the near plane; else the intersection of the rectangles of two bounding spheres.
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
 * Smallest and largest slope of a cone wholly before the eye: a tangent touches the apex, the rim of the cap, or the cap.
 * @param lateral - apex (m), with `depth`; the axis by its components in the same plane
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
