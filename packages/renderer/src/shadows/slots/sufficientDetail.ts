import type { Camera, Matrix4, SpotLight } from 'three';
import type { PictureSize } from '../../lights/PictureSize';
import type { ShadowFace } from './ShadowFace';
import type { ShadowLight } from './ShadowLight';

/** Share of a light's range in which its shadows matter: farther away the light is weak. */
export const MATTERING_RANGE = 0.5;
/**
 * Greatest width on screen of a shadow-map texel, within MATTERING_RANGE (pixels): pictures then agree within 50 dB with those
 * of full-size maps.
 */
const PIXELS = 0.7;
/**
 * Smallest height for which maps are sized (pixels), even if the picture is smaller: shadow edges fill more of a small picture,
 * and `compileAsync` draws one pixel in place of a large picture.
 */
const LEAST_HEIGHT = 720;
/** Side of the smallest map (texels). */
const SMALLEST = 16;

/** Parts of a light's shadow map that give the size of its texels. */
interface Projected {
  readonly light: ShadowLight;
  readonly isCube: boolean;
  readonly range: number;
  readonly wantedWidth: number;
  readonly wantedHeight: number;
  readonly matrix: Matrix4;
  readonly faces: readonly ShadowFace[];
}

/**
 * Number of times that a light's map can be halved before its texels exceed `PIXELS` where the light matters, in eighths
 * (integers, since engines may allocate fractional values).
 * @param picture - size (pixels)
 * @returns 0 for lights without a range, directional lights, and those near the camera
 */
export function sufficientDetail(slot: Projected, camera: Camera, picture: PictureSize): number {
  const { range, isCube, wantedWidth, wantedHeight } = slot;
  if (range === Infinity) return 0;
  const p = camera.projectionMatrix.elements;
  const v = camera.matrixWorldInverse.elements;
  // side of a pixel (m); of a perspective picture, one metre from the camera
  const pixel = 2 / Math.max(Math.abs(p[0]) * picture.width, Math.abs(p[5]) * Math.max(picture.height, LEAST_HEIGHT));
  const e = isCube ? slot.matrix.elements : slot.faces[0].camera.matrixWorld.elements;
  const sign = isCube ? -1 : 1;
  const depth = -(sign * (v[2] * e[12] + v[6] * e[13] + v[10] * e[14]) + v[14]);
  // how much closer to the camera the light's sphere or cone gets with each metre from the light, and side of a texel there (m)
  let nearer = 1;
  let texel = 2 / wantedWidth;
  if (!isCube) {
    const f = slot.faces[0].camera.projectionMatrix.elements;
    const along = v[2] * e[8] + v[6] * e[9] + v[10] * e[10];
    const { angle } = slot.light as SpotLight;
    nearer = Math.tan(Math.min(angle, 1.5)) * Math.sqrt(Math.max(0, 1 - along * along)) - along;
    texel = 2 / Math.min(f[0] * wantedWidth, f[5] * wantedHeight);
  }
  const nearest = p[11] === 0 ? 1 : depth - MATTERING_RANGE * range * nearer;
  if (p[11] !== 0 && Math.min(depth, depth - range * nearer) <= 0) return 0;
  const most = Math.log2(Math.min(wantedWidth, wantedHeight) / SMALLEST);
  const halvings = Math.min(
    Math.log2((PIXELS * pixel * nearest) / (MATTERING_RANGE * range * texel)),
    Math.floor(most),
  );
  return halvings > 0 ? Math.floor(8 * halvings) : 0;
}
