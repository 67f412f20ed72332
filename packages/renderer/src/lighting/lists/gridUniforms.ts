import type { IUniform, Texture } from 'three';

/** Uniforms of lightLoopClustered.glsl without those of tile shadows (maskUniforms.ts); one object for each FarolRenderer. */
export interface GridUniforms extends Record<string, IUniform> {
  /** Log2 of a tile's side (pixels), tiles in y, words of deep lights (see DepthBins), first record of the lights. */
  readonly farol_grid: { value: number[] };
  /** Mapping of depth to bins, see `DepthBins`: shift (m), start (the float whose bits are this integer), scale. */
  readonly farol_gridDepth: { value: number[] };
  readonly farol_gridMasks: IUniform<Texture | null>;
  readonly farol_gridBins: IUniform<Texture | null>;
}

export function gridUniforms(): GridUniforms {
  return {
    farol_grid: { value: [5, 1, 0, 0] },
    farol_gridDepth: { value: [0, 0, 0] },
    farol_gridMasks: { value: null },
    farol_gridBins: { value: null },
  };
}
