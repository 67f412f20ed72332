import { expect, it } from 'vitest';
import { growthOf, slopeOf } from './soakReport.mjs';

/** Deterministic noise, from -1 to 1. */
const noise = (i: number): number => Math.sin(i * 12.9898) * Math.cos(i * 78.233);

const samples = (heapSlope: number, objectSlope: number, count = 60) =>
  Array.from({ length: count }, (_, i) => ({
    minutes: i / 2,
    heap: 20_000 + heapSlope * (i / 2) + 300 * noise(i),
    objects: 200 + Math.round(objectSlope * (i / 2) + 4 * noise(i + 1)),
  }));

it('finds the slope of a line, and how sure it is', () => {
  expect(slopeOf([0, 1, 2, 3], [1, 3, 5, 7])).toEqual({ slope: 2, error: 0 });
  const { slope, error } = slopeOf([0, 1, 2, 3], [0, 1, 0, 1]);
  expect(slope).toBeCloseTo(0.2);
  expect(error).toBeGreaterThan(slope);
  expect(slopeOf([1, 2], [1, 2]).error).toBe(Infinity);
});

it('calls noise no growth, and a leak one', () => {
  expect(growthOf(samples(0, 0)).grows).toEqual([]);
  expect(growthOf(samples(-500, -2)).grows).toEqual([]);
  expect(growthOf(samples(200, 0)).grows).toEqual([expect.stringMatching(/^the heap grows by \d+\.\d+ ± \d+\.\d+ kB/)]);
  expect(growthOf(samples(0, 3)).grows).toEqual([expect.stringContaining('GPU objects grow')]);
});

it('leaves out what comes in at first', () => {
  const warm = samples(0, 0).map((sample, i) => (i < 12 ? { ...sample, heap: sample.heap / 3, objects: 20 } : sample));
  expect(growthOf(warm).grows).toEqual([]);
});
