import type { WebGLRenderTarget } from 'three';

/** Texels a row of a list texture, at most; WebGL 2's least MAX_TEXTURE_SIZE. */
const ROW = 2048;

/**
 * Sets farol_tiles. As many grids lie side by side in list textures as there are quads, if they fit; as many as before
 * where fewer would do, so that a light more or less takes no other textures.
 * @param tiles - the uniform's value
 * @param x - tiles in x
 * @param y - tiles in y
 * @param quads - of 128 lights, at least 1
 */
export function setTiles(tiles: number[], x: number, y: number, quads: number): void {
  if (tiles[1] !== x) tiles[0] = 0;
  while (1 << tiles[0] < quads && x << tiles[0] <= ROW / 2) tiles[0]++;
  tiles[1] = x;
  tiles[2] = y;
  tiles[3] = quads;
}

/**
 * Gives a list texture room for rows of grids of x × y texels, some more when it grows, and limits drawing to so many.
 * @param shift - grids in a row, as a power of two
 */
export function fitGrids(target: WebGLRenderTarget, x: number, y: number, grids: number, shift: number): void {
  const width = x << shift;
  const height = (((grids - 1) >> shift) + 1) * y;
  if (target.width !== width || target.height < height) target.setSize(width, height + (height >> 2));
  target.viewport.set(0, 0, width, height);
}
