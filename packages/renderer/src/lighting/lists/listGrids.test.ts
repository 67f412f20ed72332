import { WebGLRenderTarget } from 'three';
import { describe, expect, it } from 'vitest';
import { fitGrids, setTiles } from './listGrids';

describe('grids of tiles in list textures', () => {
  it('lie side by side as far as they fit in 2,048 texels', () => {
    const tiles = [0, 1, 1, 1];
    setTiles(tiles, 80, 45, 1);
    expect(tiles).toEqual([0, 80, 45, 1]);
    setTiles(tiles, 80, 45, 3);
    expect(tiles).toEqual([2, 80, 45, 3]);
    setTiles(tiles, 80, 45, 2048);
    expect(tiles).toEqual([4, 80, 45, 2048]);
    setTiles(tiles, 2049, 45, 5);
    expect(tiles).toEqual([0, 2049, 45, 5]);
  });

  it('stay where fewer would do, until there are other tiles', () => {
    const tiles = [0, 1, 1, 1];
    setTiles(tiles, 80, 45, 16);
    setTiles(tiles, 80, 45, 1);
    expect(tiles).toEqual([4, 80, 45, 1]);
    setTiles(tiles, 40, 45, 1);
    expect(tiles).toEqual([0, 40, 45, 1]);
  });

  it('give a texture whole rows and a quarter more, and limit drawing to those that there are', () => {
    const target = new WebGLRenderTarget(1, 1);
    fitGrids(target, 80, 45, 3, 4);
    expect([target.width, target.height]).toEqual([1280, 56]);
    expect(target.viewport.toArray()).toEqual([0, 0, 1280, 45]);
    fitGrids(target, 80, 45, 79, 4);
    expect([target.width, target.height]).toEqual([1280, 281]);
    expect(target.viewport.toArray()).toEqual([0, 0, 1280, 225]);
    // a light less keeps the texture
    fitGrids(target, 80, 45, 16, 4);
    expect([target.width, target.height]).toEqual([1280, 281]);
  });
});
