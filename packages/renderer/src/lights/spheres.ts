import { type Camera, type DirectionalLight, type Light, Matrix4, type SpotLight, Vector3 } from 'three';

/** Angle (rad) from axis to side above which cones are drawn and culled as spheres. */
const WIDEST_CONE = 1.05;

const lightward = new Vector3();
const coneSphere = new Float64Array(4);

const origin = new Vector3();

/** Writes the unit vector from a light's target to the light, in view space, to `axis`. @returns `axis` */
export function lightAxis(light: DirectionalLight | SpotLight, view: Matrix4, axis: Vector3): Vector3 {
  origin.setFromMatrixPosition(light.matrixWorld);
  axis.setFromMatrixPosition(light.target.matrixWorld);
  return axis.subVectors(origin, axis).transformDirection(view);
}

/**
 * The six planes of a projection in view space, unit normals pointing inward, as 24 numbers (x, y, z, w each).
 * A point p is inside when dot(n, p) + w >= 0 for all. Perspective, orthographic and off-centre projections.
 * @param m - 16 elements, column-major, clip z in [-w, w]
 * @see Gribb and Hartmann 2001, Fast Extraction of Viewing Frustum Planes
 */
export function viewFrustumPlanes(m: ArrayLike<number>, out: Float64Array): Float64Array {
  for (let i = 0; i < 6; i++) {
    const row = i >> 1;
    const sign = i & 1 ? -1 : 1;
    const x = m[3] + sign * m[row];
    const y = m[7] + sign * m[row + 4];
    const z = m[11] + sign * m[row + 8];
    const w = m[15] + sign * m[row + 12];
    const length = Math.hypot(x, y, z) || 1;
    out[i * 4] = x / length;
    out[i * 4 + 1] = y / length;
    out[i * 4 + 2] = z / length;
    out[i * 4 + 3] = w / length;
  }
  return out;
}

/** True when a sphere lies wholly on the outer side of one of the six planes of `viewFrustumPlanes`. */
export function sphereOutsidePlanes(planes: Float64Array, x: number, y: number, z: number, radius: number): boolean {
  for (let i = 0; i < 24; i += 4) {
    if (planes[i] * x + planes[i + 1] * y + planes[i + 2] * z + planes[i + 3] < -radius) return true;
  }
  return false;
}

/**
 * Approximate share of the picture that a sphere covers, 0 to 1.
 * @param depth - depth of its centre before the camera (m)
 * @param radius - radius (m)
 * @param projection - 16 elements, column-major
 */
export function sphereCoverage(depth: number, radius: number, projection: ArrayLike<number>): number {
  const p = projection;
  const scale = p[11] === 0 ? radius : radius / Math.max(depth, radius);
  return Math.min(1, (Math.PI / 4) * scale * scale * Math.abs(p[0] * p[5]));
}

/**
 * Smallest sphere round a cone with a spherical cap.
 * @param x - apex (m), with y and z
 * @param dx - unit axis from the apex into the cone, with dy and dz
 * @param range - length of the sides (m)
 * @param angle - half the opening (rad), 0 to π/2
 * @param out - receives centre and radius
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

/** View space of a camera, and the share of its picture covered by lights bounded since `begin`. */
export class ViewSpace {
  view = new Matrix4();
  /** 16 elements, column-major. */
  projection: ArrayLike<number> = [];
  /** Planes of `viewFrustumPlanes`. */
  readonly planes = new Float64Array(24);
  /** Mean number of spheres over a pixel, at any depth: sum of the shares of the picture that they cover. */
  coverage = 0;

  begin(camera: Camera): void {
    this.view = camera.matrixWorldInverse;
    this.projection = camera.projectionMatrix.elements;
    this.coverage = 0;
    viewFrustumPlanes(this.projection, this.planes);
  }
}

/**
 * Bounds the space that a light with a range lights; for a spot light by its cone too.
 * @param bounds - view-space sphere [x, y, z, r] (m) at `at`: the range r is set before, the rest is written
 * @param axes - receives the view-space [axis to the light, cosine of the cutoff] at `at`; [0, 0, 1, -1] for a sphere
 * @returns false for a light whose range the camera does not see
 */
export function boundLight(
  light: Light,
  space: ViewSpace,
  bounds: Float64Array,
  axes: Float64Array,
  at: number,
): boolean {
  const range = bounds[at + 3];
  const { elements: m } = space.view;
  const { 12: wx, 13: wy, 14: wz } = light.matrixWorld.elements;
  const x = m[0] * wx + m[4] * wy + m[8] * wz + m[12];
  const y = m[1] * wx + m[5] * wy + m[9] * wz + m[13];
  const z = m[2] * wx + m[6] * wy + m[10] * wz + m[14];
  if (sphereOutsidePlanes(space.planes, x, y, z, range)) return false;
  bounds[at] = x;
  bounds[at + 1] = y;
  bounds[at + 2] = z;
  axes[at] = axes[at + 1] = 0;
  axes[at + 2] = 1;
  axes[at + 3] = -1;
  space.coverage += sphereCoverage(-z, range, space.projection);
  if ((light as SpotLight).isSpotLight !== true || (light as SpotLight).angle >= WIDEST_CONE) return true;
  return boundCone(light as SpotLight, space, bounds, axes, at);
}

/** Bounds a spot light by its cone, after its sphere. @returns as `boundLight` */
function boundCone(light: SpotLight, space: ViewSpace, bounds: Float64Array, axes: Float64Array, at: number): boolean {
  const { angle } = light;
  const { x, y, z } = lightAxis(light, space.view, lightward);
  coneBoundingSphere(bounds[at], bounds[at + 1], bounds[at + 2], -x, -y, -z, bounds[at + 3], angle, coneSphere);
  if (sphereOutsidePlanes(space.planes, coneSphere[0], coneSphere[1], coneSphere[2], coneSphere[3])) {
    space.coverage -= sphereCoverage(-bounds[at + 2], bounds[at + 3], space.projection);
    return false;
  }
  axes[at] = x;
  axes[at + 1] = y;
  axes[at + 2] = z;
  axes[at + 3] = Math.cos(angle);
  return true;
}
