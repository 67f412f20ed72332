import { Vector4 } from 'three';
import { describe, expect, it } from 'vitest';
import { gridFit, gridShift, gridTexels } from './gridFit';

/** Texel coordinate in the buffer for a pixel coordinate of the picture. */
function texelOf(pixel: number, pixels: number, scale: number): number {
  const { x, z } = gridFit(pixels, 1, scale, new Vector4());
  const device = ((pixel / pixels) * 2 - 1) * x + z;
  return (device * 0.5 + 0.5) * gridTexels(pixels, scale);
}

describe('the grid of a smaller buffer', () => {
  it.each([1, 2, 3, 4, 5])('has its texel centres on pixel centres at 1 / %i of the resolution', (fraction) => {
    for (const pixels of [60, 61, 319]) {
      for (let texel = 0; texel < 10; texel++) {
        const pixel = (texel + 0.5) * fraction - gridShift(1 / fraction);
        expect(pixel - Math.floor(pixel)).toBeCloseTo(0.5, 8);
        expect(texelOf(pixel, pixels, 1 / fraction)).toBeCloseTo(texel + 0.5, 8);
      }
    }
  });

  it('is the picture itself at full resolution', () => {
    expect(gridFit(321, 239, 1, new Vector4()).toArray()).toEqual([1, 1, 0, 0]);
    expect([gridTexels(321, 1), gridShift(1)]).toEqual([321, 0]);
  });

  it('has texels of one width, a texel at least, and one for every pixel but half a texel at the far edge', () => {
    for (const scale of [0.01, 0.25, 0.4, 0.5, 0.66, 0.99]) {
      for (const pixels of [1, 2, 319, 320]) {
        const first = texelOf(0, pixels, scale);
        const last = texelOf(pixels, pixels, scale);
        expect(first).toBeGreaterThanOrEqual(-1e-9);
        expect(last - first).toBeCloseTo(pixels * scale, 6);
        expect(last).toBeLessThanOrEqual(gridTexels(pixels, scale) + scale + 1e-9);
      }
    }
  });
});
