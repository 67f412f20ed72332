import { expect, test } from 'vitest';
import { marksBetween, rulerSteps } from './rulerSteps';

test('a ruler has the marks between two places, as multiples of its step', () => {
  expect(marksBetween(0.35, 1, 0.2)).toEqual([2, 3, 4, 5]);
  expect(marksBetween(-0.4, 0.4, 0.2)).toEqual([-2, -1, 0, 1, 2]);
  expect(marksBetween(0.1, 0.15, 0.2)).toEqual([]);
});

test('where numbers have no digits left for its marks it has none, and ends', () => {
  // regression: keys at such times or with such values froze the editor when they came into view
  for (const place of [1e13, 1e16, 1e17, 1e300, Infinity, NaN]) {
    expect(marksBetween(place, place + 1e-3, 1e-4).length).toBeLessThan(20);
    expect(marksBetween(-place, -place + 10, 0.1).length).toBeLessThan(200);
  }
  expect(marksBetween(0, 1e9, 0.1)).toEqual([]);
  for (const scale of [0, 1e-300, 1e300, NaN]) {
    const { step } = rulerSteps(scale, 30, 'seconds');
    expect(marksBetween(0, 1, step).length).toBeLessThan(2000);
  }
});
