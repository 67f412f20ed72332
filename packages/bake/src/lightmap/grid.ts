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
  /** Of all light, and of the luminance of that which lights have not given. */
  readonly sums: WebGLRenderTarget;
  /** A filter reads the first and writes the second. */
  readonly light: WebGLRenderTarget[];
}

/** What a grid of so many texels along a side needs, but for `settled`. */
export const gridTargets = (size: number): Omit<Grid, 'settled'> => ({
  size,
  places: placeTarget(size),
  sums: sumsTarget(size),
  light: [texelTarget(size, FloatType), texelTarget(size, FloatType)],
});
