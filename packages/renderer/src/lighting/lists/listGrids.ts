import type { WebGLRenderTarget } from 'three';
import { withRoom } from '../../gpu/fitTarget';

/** Maximum width of a list texture (texels): MAX_TEXTURE_SIZE that WebGL 2 guarantees. */
const ROW = 2048;

/**
 * Sets the uniform `farol_tiles`. List textures hold a grid of tiles for each quad (128 lights) side by side, if they fit. The
 * number of quads is kept when fewer suffice, so that one light more or less needs no new textures.
 * @param tiles - the uniform's value
 * @param x - tiles in x
 * @param y - tiles in y
 * @param quads - number of quads of 128 lights, at least 1
 */
export function setTiles(tiles: number[], x: number, y: number, quads: number): void {
  if (tiles[1] !== x) tiles[0] = 0;
  while (1 << tiles[0] < quads && x << tiles[0] <= ROW / 2) tiles[0]++;
  tiles[1] = x;
  tiles[2] = y;
  tiles[3] = quads;
}

/**
 * Makes a list texture large enough for rows of grids of x × y texels, with some spare rows when it grows, and limits drawing to
 * those.
 * @param shift - log2 of the number of grids in a row
 */
export function fitGrids(target: WebGLRenderTarget, x: number, y: number, grids: number, shift: number): void {
  const width = x << shift;
  const height = (((grids - 1) >> shift) + 1) * y;
  const made = withRoom(target.width, width);
  if (target.width !== made || target.height < height) target.setSize(made, withRoom(0, height + (height >> 2)));
  target.viewport.set(0, 0, width, height);
}
