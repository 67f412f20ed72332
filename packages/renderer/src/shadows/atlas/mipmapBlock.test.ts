import { WebGLRenderTarget } from 'three';
import { expect, test } from 'vitest';
import { AtlasMap } from './AtlasMap';
import { AtlasPlacement } from './AtlasPlacement';
import { levelBottom, levelLeft, levelSpan, mipmapBlockHeight, mipmapBlockWidth } from './mipmapBlock';
import { TextureAtlas } from './TextureAtlas';

const sizes = [1, 2, 3, 4, 5, 7, 16, 63, 64, 100, 1024];
const levelsOf = (width: number, height: number) => 1 + Math.floor(Math.log2(Math.max(width, height)));

test('mipmap levels of images and cubes lie in their block, apart from one another', () => {
  for (const width of sizes) {
    for (const height of sizes) {
      for (const [across, up] of [
        [1, 1],
        [3, 2],
      ]) {
        for (let levels = 1; levels <= levelsOf(width, height); levels++) {
          const rectangles = Array.from({ length: levels }, (_, level) => {
            const [left, bottom] = [levelLeft(width, level, across), levelBottom(height, level, up)];
            return [left, bottom, left + levelSpan(width, level, across), bottom + levelSpan(height, level, up)];
          });
          const name = `${width} × ${height}, ${levels} levels, ${across} faces across`;
          expect(Math.max(...rectangles.map((each) => each[2])), name).toBe(mipmapBlockWidth(width, levels, across));
          expect(Math.max(...rectangles.map((each) => each[3])), name).toBe(mipmapBlockHeight(height, levels, up));
          rectangles.forEach((a, i) => {
            for (const b of rectangles.slice(i + 1))
              expect(a[2] <= b[0] || b[2] <= a[0] || a[3] <= b[1] || b[3] <= a[1], name).toBe(true);
          });
        }
      }
    }
  }
});

test('a cube with mipmaps that is larger than the largest atlas has faces that fit it', () => {
  for (const limit of [1024, 2048, 4096]) {
    const atlas = new TextureAtlas(
      limit,
      () => 8,
      (size) => new WebGLRenderTarget(size, size),
    );
    const placement = new AtlasPlacement();
    const map = new AtlasMap();
    const size = { wantedWidth: 2048, wantedHeight: 2048, levels: 12, coverage: 1 };
    atlas.arrange([{ isCube: true, placement, map, borderOf: () => 1, ...size }], [], true);
    expect(placement.region, `limit ${limit}`).not.toBeNull();
    expect(placement.faceWidth).toBeGreaterThan(0.9 * Math.min(2048, limit / 3));
  }
});
