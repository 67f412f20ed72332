import { expect, it } from 'vitest';
import { LEVEL_BORDER, levelBottom, mipmapBlockHeight, mipmapBlockWidth } from './mipmapBlock';

it.each([
  [256, 256, 9],
  [256, 16, 9],
  [16, 256, 9],
  [64, 64, 1],
  [37, 21, 6],
  [1, 1, 1],
])(
  'levels of an image of %i × %i lie in their block with their borders, and none upon another',
  (width, height, levels) => {
    const [blockWidth, blockHeight] = [mipmapBlockWidth(width, levels), mipmapBlockHeight(height, levels)];
    const texels = new Uint8Array(blockWidth * blockHeight);
    for (let level = 0; level < levels; level++) {
      // as CookieDraws and lightImage.glsl place them
      const left = level === 0 ? 0 : width + 2 * LEVEL_BORDER;
      const bottom = levelBottom(height, level);
      const right = left + Math.max(1, width >> level) + 2 * LEVEL_BORDER;
      const top = bottom + Math.max(1, height >> level) + 2 * LEVEL_BORDER;
      expect(right, `right side of level ${level}`).toBeLessThanOrEqual(blockWidth);
      expect(top, `upper side of level ${level}`).toBeLessThanOrEqual(blockHeight);
      for (let y = bottom; y < top; y++) for (let x = left; x < right; x++) texels[y * blockWidth + x]++;
    }
    expect(Math.max(...texels)).toBe(1);
  },
);
