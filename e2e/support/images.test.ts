import { describe, expect, it } from 'vitest';
import { compareImages, encodeSRGB, type FloatImage, isFlat } from './images';

const grey = (...values: number[]): FloatImage => ({
  width: values.length,
  height: 1,
  data: values.flatMap((value) => [value, value, value, 1]),
});

describe('compareImages', () => {
  it('finds equal images equal', () => {
    const equal = { largest: 0, psnr: Infinity, share: 0, alpha: 0 };
    expect(compareImages(grey(0.2, 0.5), grey(0.2, 0.5))).toEqual(equal);
  });

  it('tells of alpha apart from colour, and counts its pixels', () => {
    const other = grey(0.2, 0.5);
    other.data = [0.2, 0.2, 0.2, 1 - 1e-3, 0.5, 0.5, 0.5, 0.5];
    expect(compareImages(grey(0.2, 0.5), other)).toEqual({ largest: 0, psnr: Infinity, share: 0.5, alpha: 0.5 });
    other.data = [0.2, 0.2, 0.2, 1, 0.5, 0.5, 0.5, Number.NaN];
    expect(compareImages(grey(0.2, 0.5), other)).toMatchObject({ psnr: Infinity, share: 0.5, alpha: Infinity });
  });

  it('gives the PSNR of a known error', () => {
    // one of two pixels off by 1 in all channels: mean square 0.5
    expect(compareImages(grey(0, 0), grey(0, 1)).psnr).toBeCloseTo(10 * Math.log10(2), 6);
  });

  it('counts a pixel off by three steps of 255 and not one off by one', () => {
    const decode = (encoded: number) => ((encoded + 0.055) / 1.055) ** 2.4;
    const base = decode(100 / 255);
    expect(compareImages(grey(base, base), grey(decode(101 / 255), decode(103 / 255)), 2).share).toBe(0.5);
  });

  it('counts no byte that is two steps off, kept as linear floats of 32 bits', () => {
    const decode = (byte: number) => (byte <= 10 ? byte / 3294.6 : ((byte / 255 + 0.055) / 1.055) ** 2.4);
    const bytes = (first: number) => ({
      ...grey(...Array.from({ length: 253 }, () => 0)),
      data: Float32Array.from({ length: 253 * 4 }, (_, i) => (i % 4 === 3 ? 1 : decode((i >> 2) + first))),
    });
    expect([2, 3].map((off) => compareImages(bytes(0), bytes(off)).share)).toEqual([0, 1]);
  });

  it('takes NaN for the largest error there is', () => {
    expect(compareImages(grey(0.5), grey(Number.NaN))).toMatchObject({ largest: Infinity, share: 1 });
  });

  it('takes light that is infinite in both for equal, in one for the largest error', () => {
    expect(compareImages(grey(0.5, Infinity), grey(0.5, Infinity))).toMatchObject({
      largest: 0,
      psnr: Infinity,
      share: 0,
    });
    expect(compareImages(grey(0.5, Infinity), grey(0.5, 0.7))).toMatchObject({ largest: Infinity, share: 0.5 });
    expect(compareImages(grey(Number.NaN), grey(Number.NaN))).toMatchObject({ largest: Infinity, share: 1 });
  });

  it('refuses images of two sizes', () => {
    expect(() => compareImages(grey(1), grey(1, 1))).toThrow(/1×1 and 2×1/);
  });
});

describe('isFlat', () => {
  it('sees one pixel that differs', () => {
    expect(isFlat(grey(0.5, 0.5, 0.5))).toBe(true);
    expect(isFlat(grey(0.5, 0.52, 0.5))).toBe(false);
  });

  it('does not take a picture with NaN for a good one', () => {
    expect(isFlat(grey(0.1, Number.NaN, 0.9))).toBe(true);
  });
});

it('encodeSRGB meets the standard at its ends, its knee and mid grey', () => {
  expect(encodeSRGB(-1)).toBe(0);
  expect(encodeSRGB(2)).toBe(1);
  expect(encodeSRGB(0.0031308)).toBeCloseTo(0.04045, 5);
  expect(encodeSRGB(0.21404114)).toBeCloseTo(0.5, 6);
});
