import { describe, expect, it } from 'vitest';
import { atlasLimit, liteAtlasBytes } from './atlasLimit';

const slot = (range: number, wanted: number, isCube = false, side = 1) => ({
  range,
  isCube,
  side,
  wantedWidth: wanted,
  wantedHeight: wanted,
});

describe('atlasLimit', () => {
  it.each([
    [1280, 720, 6656],
    [320, 180, 6656],
    [1, 1, 6656],
    [1600, 900, 8192],
    [1440, 720, 7168],
    [1920, 1080, 8192],
    [7680, 4320, 8192],
  ])('is a share of the pixels, whatever lights with a range ask for: %d × %d', (width, height, expected) => {
    expect(atlasLimit({ width, height }, [slot(5, 4096), slot(5, 1024, true)])).toBe(expected);
  });

  it('has room beside for lights without a range: all faces, all cascades, and the widest of them', () => {
    const picture = { width: 1280, height: 720 };
    const limit = (...slots: ReturnType<typeof slot>[]) => atlasLimit(picture, slots);
    expect(limit(slot(Infinity, 1024))).toBe(6912); // the root of 45.3 million, in steps of 256
    expect(limit(slot(Infinity, 1024, true))).toBe(7168); // 50.5 million
    expect(limit(slot(Infinity, 1024, false, 2))).toBe(7168); // 48.4 million
    expect(limit(slot(Infinity, 8192))).toBe(8192);
    expect(limit(...Array.from({ length: 5 }, () => slot(Infinity, 1024)))).toBe(7168); // 49.5 million
  });

  it('is as wide as one map, however low', () => {
    const low = { ...slot(Infinity, 7900), wantedHeight: 16 };
    expect(atlasLimit({ width: 1, height: 1 }, [low])).toBe(7936);
    const cascades = { ...slot(Infinity, 16, false, 2), wantedHeight: 3900 };
    expect(atlasLimit({ width: 1, height: 1 }, [cascades])).toBe(7936);
  });
});

it('with the quality lite it is bounded by bytes: 10 a pixel of the picture, which counts as 1280 × 720 at least', () => {
  expect(liteAtlasBytes({ width: 1920, height: 1080 })).toBe(20_736_000);
  expect(liteAtlasBytes({ width: 64, height: 64 })).toBe(9_216_000);
});
