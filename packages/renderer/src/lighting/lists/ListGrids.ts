import type { WebGLRenderTarget } from 'three';

/** Texels a row of a list texture, at most; WebGL 2's least MAX_TEXTURE_SIZE. */
const ROW = 2048;

/** How many grids of tiles lie side by side in list textures: as many as there are quads of lights, if they fit. */
export class ListGrids {
  private shift = 0;
  private tiles = 0;

  /**
   * Stays where fewer would do, so that a light more or less takes no other textures.
   * @param tiles in x
   * @param quads of 128 lights, at least 1
   * @returns grids in a row, as a power of two
   */
  inRow(tiles: number, quads: number): number {
    let shift = 0;
    while (1 << shift < quads && tiles << (shift + 1) <= ROW) shift++;
    if (tiles !== this.tiles) this.shift = shift;
    this.tiles = tiles;
    return (this.shift = Math.max(this.shift, shift));
  }
}

/**
 * Gives a list texture room for grids of x × y texels, some more when it grows, and limits drawing to so many.
 * @param shift grids in a row, as a power of two
 */
export function fitGrids(target: WebGLRenderTarget, x: number, y: number, grids: number, shift: number): void {
  const rows = Math.ceil(grids / (1 << shift));
  if (target.width !== x << shift || target.height % y !== 0 || target.height < rows * y)
    target.setSize(x << shift, (rows === 1 ? 1 : Math.ceil(rows * 1.25)) * y);
  target.viewport.set(0, 0, Math.min(grids, 1 << shift) * x, rows * y);
}
