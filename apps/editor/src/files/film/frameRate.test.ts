import { expect, it } from 'vitest';
import { framesBetween, knownRates, rateOf, timeOf } from './frameRate';

it.each([
  ['60', 0, 10, 0, 600],
  ['24', 1.5, 2.5, 36, 24],
  ['23.976', 0, 10, 0, 240],
  ['29.97', 0, 1001, 0, 30_000],
  ['25', 2, 2, 50, 1],
])('%s frames a second from %f to %f s: frame %i on, %i frames', (rate, from, to, first, count) => {
  expect(framesBetween(from, to, knownRates[rate])).toEqual({ first, count });
});

it('does not drift: frame 24,000 of 23.976 a second is at 1001 s', () => {
  expect(timeOf(24_000, rateOf(23.976))).toBe(1001);
});

it('takes other rates as they are', () => {
  expect(timeOf(37, rateOf(12.5))).toBe(2.96);
  expect(timeOf(1, rateOf(0.1))).toBe(10);
});
