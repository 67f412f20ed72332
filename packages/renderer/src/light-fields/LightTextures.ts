import type { Texture } from 'three';

/**
 * Lights of a LightField as textures that the GPU may write, a texel a light, row after row: light `i` is texel
 * `(i % width, floor(i / width))`. All have one size. Nearest texels are read; filters and mipmaps do not matter.
 */
export interface LightTextures {
  /** RGBA32F: position in the field's space, range (m); a range of 0 or less, or a value that is no number: no light. */
  sphere: Texture;
  /** RGBA32F or RGBA16F: linear colour times intensity (cd), decay as three has it. */
  emission: Texture;
  /**
   * RGBA32F: direction in which a spot light shines, in the field's space, of the length 2 + the cosine of the angle from
   * which on it fades (angle × (1 - penumbra)); cosine of its angle. Zeros: a point light. Default: all are point lights.
   */
  cone?: Texture | null;
}
