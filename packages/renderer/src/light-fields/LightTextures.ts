import type { Texture } from 'three';

/**
 * Lights of a LightField as textures that the GPU may write, a texel for each light, row by row: light `i` is texel
 * `(i % width, floor(i / width))`. All have one size. Single texels are read; filters and mipmaps have no effect.
 */
export interface LightTextures {
  /** RGBA32F: position in the field's space, range (m); a range of 0 or less, or a NaN: no light. */
  sphere: Texture;
  /** RGBA32F or RGBA16F: linear colour times intensity (cd), three's `decay`. */
  emission: Texture;
  /**
   * RGBA32F: xyz: direction of a spot light's light, in the field's space, with the length 2 + cosine of the angle where it
   * begins to fade (angle × (1 - penumbra)); w: cosine of its angle. Zeros: a point light. Default: all are point lights.
   */
  cone?: Texture | null;
}
