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
 * What a light of the thesis (3.2.5.3) has and a three.js light has not. Plain JSON at `light.userData.farol`,
 * read anew each frame.
 */
export interface FarolLightData {
  /** Times the light's intensity: light given to every surface in reach whatever its normal. Default black. */
  ambient?: LinearRGB;
  /** Times the light's intensity: colour of the specular term. Default: the light's own colour. */
  specular?: LinearRGB;
  /** `cos(angle)^spotExponent` inside the cutoff angle, in place of three's penumbra. At least 0. */
  spotExponent?: number;
  /** Default: three's physical falloff by `distance` and `decay`. */
  attenuation?: FarolAttenuation;
}
