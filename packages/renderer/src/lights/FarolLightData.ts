/** A linear RGB triple, each at least 0. */
export type LinearRGB = readonly [number, number, number];

/** Attenuation of a local light, in place of three's physical falloff. Distances in metres. */
export type FarolAttenuation =
  /** 1 up to `near`, then linear, exactly 0 from `far` on. */
  | { readonly kind: 'near-far'; readonly near: number; readonly far: number }
  /** `1 / (constant + linear d + quadratic d²)`, 0 beyond `range`; `range` 0 means no limit. */
  | {
      readonly kind: 'polynomial';
      readonly constant: number;
      readonly linear: number;
      readonly quadratic: number;
      readonly range: number;
    };

/**
 * What a RectAreaLight is. 'rectangle', as in three; 'disc': the ellipse in it; both shine along the light's -z. 'tube':
 * `width` long along the light's x, `height` thick, shines all round but not at its ends; right where it is thin against its
 * distance. Stock three draws all as rectangles.
 */
export type AreaLightShape = 'rectangle' | 'disc' | 'tube';

/**
 * What a light of the thesis (3.2.5.3) or an area light has and a three.js light has not: options of `setLightOptions`, which
 * keeps them as plain JSON at `light.userData.farol`, read anew each frame.
 */
export interface FarolLightData {
  /**
   * Times the light's intensity: light given to every surface in reach whatever its normal; also times the material's own
   * ambient factor, where a material's shader has one: `#define FAROL_AMBIENT_FACTOR`, a colour. Default black.
   */
  ambient?: LinearRGB;
  /** Times the light's intensity: colour of the specular term. Default: the light's own colour. */
  specular?: LinearRGB;
  /** `cos(angle)^spotExponent` inside the cutoff angle, in place of three's penumbra. At least 0. */
  spotExponent?: number;
  /** Default: three's physical falloff by `distance` and `decay`. */
  attenuation?: FarolAttenuation;
  /** Of a RectAreaLight. Default 'rectangle', as in three. */
  shape?: AreaLightShape;
  /**
   * Of a RectAreaLight: distance from its surface (m) from which on it gives nothing; up to half of that it gives what three
   * has it give. Above 0; 0 for no end. Default: where `FarolRenderer.areaLightThreshold` puts it.
   */
  range?: number;
  /** Of a RectAreaLight that casts shadows: texels across a face of its map, 16 to 8,192. Default 1,024. */
  shadowMapSize?: number;
  /** Of such a light: how far off a surface, along its normal, the map is looked up (m). At least 0. Default 0.03. */
  shadowNormalBias?: number;
  /** Of a point or spot light that @farol/bake bakes: radius of the ball that shines (m), for soft shadows. Default 0. */
  radius?: number;
  /** Of a directional light that @farol/bake bakes: angle that the sun covers (rad), for soft shadows. Default 0. */
  angle?: number;
}
