import { FloatType, type WebGLRenderTarget } from 'three';
import { placeTarget, sumsTarget, texelTarget } from './targets';

/** Texels at which light is reckoned. */
export interface Grid {
  /** Texels along a side. */
  readonly size: number;
  /** Positions, normals and normals of faces. */
  readonly places: WebGLRenderTarget;
  /** Positions as settle.glsl has moved them, where those are apart. */
  readonly settled: WebGLRenderTarget | null;
  /** Sums over all light, and sums of the luminance of light that does not come straight from lights. */
  readonly sums: WebGLRenderTarget;
  /** A filter reads the first and writes the second. */
  readonly light: WebGLRenderTarget[];
}

/** Targets of a grid of `size` texels along a side, without `settled`. */
export const gridTargets = (size: number): Omit<Grid, 'settled'> => ({
  size,
  places: placeTarget(size),
  sums: sumsTarget(size),
  light: [texelTarget(size, FloatType), texelTarget(size, FloatType)],
});
