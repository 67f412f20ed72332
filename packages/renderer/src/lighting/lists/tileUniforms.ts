import { Vector2, type IUniform, type Texture } from 'three';

/** Log2 of a tile's side (pixels); FAROL_TILE_SHIFT in lightTiles.glsl. */
export const TILE_SHIFT = 4;

/** Uniforms of lightTiles.glsl, lightLoopTiled.glsl and viewport.glsl; one object for each FarolRenderer. */
export interface TileUniforms extends Record<string, IUniform> {
  /** Log2 of the number of grids of tiles side by side in a list texture, tiles in x, tiles in y, quads of 128 lights a tile. */
  readonly farol_tiles: { value: number[] };
  /** First record of the listed lights, their number, texels of `farol_tileSummary` a tile, plain quads (of 128). */
  readonly farol_tileRun: { value: number[] };
  readonly farol_tileMask: IUniform<Texture | null>;
  readonly farol_tileSummary: IUniform<Texture | null>;
  /** Lower left corner of the viewport in the render target (pixels). */
  readonly farol_offset: { value: Vector2 };
}

export function tileUniforms(): TileUniforms {
  return {
    farol_tiles: { value: [0, 1, 1, 1] },
    farol_tileRun: { value: [0, 0, 1, 0] },
    farol_tileMask: { value: null },
    farol_tileSummary: { value: null },
    farol_offset: { value: new Vector2() },
  };
}
