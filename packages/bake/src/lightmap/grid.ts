import { FloatType, type WebGLRenderTarget } from 'three';
import { placeTarget, sumsTarget, texelTarget } from './targets';

/** Square grid of texels at which light is gathered, with its render targets. */
export interface Grid {
  /** Side of the grid (texels). */
  readonly size: number;
  /** World-space positions, normals and face normals of the texels, three textures. */
  readonly places: WebGLRenderTarget;
  /** Positions moved out of walls by settle.glsl; null where `places` has the final ones. */
  readonly settled: WebGLRenderTarget | null;
  /** Sums of samples, two textures: all light, and the luminance of light from sky and emissive surfaces. */
  readonly sums: WebGLRenderTarget;
  /** Two targets of filtered light: a filter reads the first and writes the second. */
  readonly light: WebGLRenderTarget[];
}

/** Targets of a grid of `size` texels along a side, without `settled`. */
export const gridTargets = (size: number): Omit<Grid, 'settled'> => ({
  size,
  places: placeTarget(size),
  sums: sumsTarget(size),
  light: [texelTarget(size, FloatType), texelTarget(size, FloatType)],
});
