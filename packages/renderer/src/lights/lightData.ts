import type { Light, PointLight, RectAreaLight } from 'three';
import { rangeOf } from './plainPoints';

/** A linear RGB triple, each at least 0. */
export type LinearRGB = readonly [number, number, number];

/** Attenuation of a local light, in place of three's physical falloff. Distances in metres. */
export type FarolAttenuation =
  /** Factor: 1 up to `near`, then linear, exactly 0 from `far` on. */
  | { readonly kind: 'near-far'; readonly near: number; readonly far: number }
  /** Factor: `1 / (constant + linear d + quadratic d²)`, 0 beyond `range`; `range` 0 means no limit. */
  | {
      readonly kind: 'polynomial';
      readonly constant: number;
      readonly linear: number;
      readonly quadratic: number;
      readonly range: number;
    };

/**
 * Shape of a RectAreaLight. 'rectangle', as in three; 'disc': the inscribed ellipse; both emit along the light's -z. 'tube':
 * `width` long along the light's x, `height` thick, emits all around but not from its ends; accurate if thin compared to its
 * distance. Stock three draws all as rectangles.
 */
export type AreaLightShape = 'rectangle' | 'disc' | 'tube';

/**
 * Properties that three.js lights lack: of the thesis's lights (3.2.5.3), area lights and baked lights. Set by
 * `setLightOptions`, which keeps them as plain JSON at `light.userData.farol`, read again in each frame.
 */
export interface FarolLightData {
  /**
   * Light on every surface in range, for any normal, as a factor on the light's intensity; multiplied by the material's ambient
   * factor, if its shader defines one: the colour `FAROL_AMBIENT_FACTOR`. Default black.
   */
  ambient?: LinearRGB;
  /** Colour of the specular term, as a factor on the light's intensity. Default: the light's own colour. */
  specular?: LinearRGB;
  /**
   * Exponent of a spot light's falloff, `cos(angle)^spotExponent`, inside the cutoff angle, in place of three's
   * penumbra. At least 0.
   */
  spotExponent?: number;
  /** Falloff with distance. Default: three's physical falloff by `distance` and `decay`. */
  attenuation?: FarolAttenuation;
  /** Shape of a RectAreaLight. Default 'rectangle', as in three. */
  shape?: AreaLightShape;
  /**
   * Distance (m) from a RectAreaLight's surface beyond which it gives nothing; up to half of it the light is as bright as in
   * three. Above 0, or 0 for no end. Default: by `FarolRenderer.areaLightThreshold`.
   */
  range?: number;
  /** Texels across a face of the shadow map of a RectAreaLight, 16 to 8,192. Default 1,024. */
  shadowMapSize?: number;
  /** Offset along the surface's normal (m) at which a RectAreaLight's shadow map is sampled. At least 0. Default 0.03. */
  shadowNormalBias?: number;
  /** Radius (m) of a point or spot light as a sphere, for soft shadows baked by @farol/bake. Default 0. */
  radius?: number;
  /** Angular diameter (rad) of a directional light, for soft shadows baked by @farol/bake. Default 0. */
  angle?: number;
}

/** Properties of a LightField that light collection reads. */
export interface LightFieldData extends Light {
  readonly capacity: number;
  readonly count: number;
}

/** Number of lights that a light field draws. */
export function fieldCount({ capacity, count }: LightFieldData): number {
  return Math.max(0, Math.min(capacity, Math.floor(count) || 0));
}

/** Radii of area lights; implemented by late code. */
export interface AreaRadii {
  /** Radius (m) of a sphere around a light's centre that contains all it lights; 0 for no end, NaN for a black light. */
  radiusOf(light: RectAreaLight): number;
}

/** Distance from which on a light gives nothing (m); 0 for a light without a range. */
export function lightRange(light: PointLight): number {
  const attenuation = (light.userData.farol as FarolLightData | undefined)?.attenuation;
  let range = light.distance;
  if (attenuation !== undefined) range = attenuation.kind === 'near-far' ? attenuation.far : attenuation.range;
  return rangeOf(range);
}
