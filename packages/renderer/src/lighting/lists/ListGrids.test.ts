import { WebGLRenderTarget } from 'three';
import { describe, expect, it } from 'vitest';
import { fitGrids, ListGrids } from './ListGrids';

describe('grids of tiles in list textures', () => {
  it('lie side by side as far as they fit in 2,048 texels', () => {
    const grids = new ListGrids();
    expect(grids.inRow(80, 1)).toBe(0);
    expect(grids.inRow(80, 3)).toBe(2);
    expect(grids.inRow(80, 2048)).toBe(4);
    expect(grids.inRow(2049, 5)).toBe(0);
  });

  it('stay where fewer would do, until there are other tiles', () => {
    const grids = new ListGrids();
    expect(grids.inRow(80, 16)).toBe(4);
    expect(grids.inRow(80, 1)).toBe(4);
    expect(grids.inRow(40, 1)).toBe(0);
  });

  it('give a texture whole grids, and limit drawing to those that there are', () => {
    const target = new WebGLRenderTarget(1, 1);
    fitGrids(target, 80, 45, 3, 4);
    expect([target.width, target.height]).toEqual([1280, 45]);
    expect(target.viewport.toArray()).toEqual([0, 0, 240, 45]);
    fitGrids(target, 80, 45, 79, 4);
    expect([target.width, target.height]).toEqual([1280, 315]);
    expect(target.viewport.toArray()).toEqual([0, 0, 1280, 225]);
    // a light more or less keeps the texture
    fitGrids(target, 80, 45, 97, 4);
    expect([target.width, target.height]).toEqual([1280, 315]);
  });
});
