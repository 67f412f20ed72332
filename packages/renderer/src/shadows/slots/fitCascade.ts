import { type Camera, type OrthographicCamera, type PerspectiveCamera, Vector3 } from 'three';
import type { ShadowFace } from './ShadowFace';
import { setReversedDepth } from '../../three/reversedDepth';

/** Ratio of the distance that a cascade reaches to that of the cascade before. */
const STEP = 4;

const centre = new Vector3();

/**
 * Fits the camera of a cascade around the near part of a viewer's frustum: a box whose size and rotation do not follow the
 * viewer, moved by whole texels, so that shadows do not crawl.
 * @param whole - the light's whole shadow camera, whose map is the last one
 * @param viewer - camera of the picture
 * @param wider - number of cascades that are wider than this one, at least 1
 * @param width - width of the map (texels)
 * @param height - height of the map (texels)
 * @param out - receives the transform of coordinates in the map of `whole` to the cascade's: scale and shift of x, scale and
 *   shift of y
 * @see Valient 2008, Stable Rendering of Cascaded Shadow Maps (ShaderX6)
 */
export function fitCascade(
  face: ShadowFace,
  whole: OrthographicCamera,
  viewer: Camera,
  wider: number,
  width: number,
  height: number,
  out: Float64Array,
): void {
  const { left, right, top, bottom } = whole;
  const wide = right - left;
  const high = top - bottom;
  const radius = sphereWithin(viewer, Math.max(wide, high) / STEP ** wider);
  centre.applyMatrix4(viewer.matrixWorld).applyMatrix4(whole.matrixWorldInverse);
  const texelX = (2 * radius) / width;
  const texelY = (2 * radius) / height;
  const x = Math.floor(centre.x / texelX) * texelX;
  const y = Math.floor(centre.y / texelY) * texelY;
  const camera = face.camera as OrthographicCamera;
  setReversedDepth(camera, whole.reversedDepth);
  camera.left = x - radius;
  camera.right = x + radius;
  camera.bottom = y - radius;
  camera.top = y + radius;
  camera.near = whole.near;
  camera.far = whole.far;
  camera.updateProjectionMatrix();
  camera.matrixWorld.copy(whole.matrixWorld);
  camera.matrixWorldInverse.copy(whole.matrixWorldInverse);
  face.update();
  out[0] = wide / (2 * radius);
  out[1] = (left - x + radius) / (2 * radius);
  out[2] = high / (2 * radius);
  out[3] = (bottom - y + radius) / (2 * radius);
}

/**
 * Finds the sphere around a camera's frustum up to a distance (m): writes its centre (view space) to `centre`. For a camera that
 * draws a tile (`setViewOffset`), the whole picture's frustum, so that tiles meet without a seam.
 * @returns its radius (m)
 */
function sphereWithin(viewer: Camera, distance: number): number {
  const p = viewer.projectionMatrix.elements;
  const near = (viewer as PerspectiveCamera).near;
  const far = Math.max(distance, near * 1.5);
  const { view } = viewer as PerspectiveCamera;
  const isTile = view?.enabled === true;
  const x = (isTile ? view.fullWidth / view.width : 1) / p[0];
  const y = (isTile ? view.fullHeight / view.height : 1) / p[5];
  if (p[11] === 0) {
    centre.set(0, 0, -0.5 * (near + far));
    return Math.hypot(x, y, 0.5 * (far - near));
  }
  const slope = x * x + y * y;
  const middle = Math.min(far, 0.5 * (near + far) * (1 + slope));
  centre.set(0, 0, -middle);
  return Math.sqrt((far - middle) * (far - middle) + far * far * slope);
}
