import { expect, it } from 'vitest';
import { tilesOf } from './tilesOf';

it.each([
  [1920, 1080],
  [4096, 4096],
  [4097, 3],
  [20_000, 9_001],
])('tiles cover %i × %i pixels once, each within what is drawn of it', (width, height) => {
  const strips = tilesOf(width, height);
  const tiles = strips.flat();
  expect(tiles.reduce((sum, tile) => sum + tile.width * tile.height, 0)).toBe(width * height);
  for (const strip of strips) {
    expect(strip.reduce((sum, tile) => sum + tile.width, 0)).toBe(width);
    for (const { y, height: high } of strip) expect([y, high]).toEqual([strip[0].y, strip[0].height]);
  }
  for (const { x, y, width: wide, height: high, drawn } of tiles) {
    expect(
      drawn.x <= x && drawn.y <= y && x + wide <= drawn.x + drawn.width && y + high <= drawn.y + drawn.height,
    ).toBe(true);
    expect(Math.max(drawn.width, drawn.height)).toBeLessThanOrEqual(4096);
    // a margin for effects that read neighbours across a seam
    if (x > 0) expect(x - drawn.x).toBe(64);
    if (x + wide < width) expect(drawn.x + drawn.width).toBe(Math.min(width, x + wide + 64));
  }
});
