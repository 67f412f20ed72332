import { describe, expect, it } from 'vitest';
import { atlasLimit } from './atlasLimit';

describe('atlasLimit', () => {
  it.each([
    [1280, 720, 6656],
    [320, 180, 6656],
    [1, 1, 6656],
    [1600, 900, 8192],
    [1440, 720, 7168],
    [1920, 1080, 8192],
    [7680, 4320, 8192],
  ])('is a share of the pixels: %d × %d', (width, height, expected) => {
    expect(atlasLimit({ width, height })).toBe(expected);
  });
});
