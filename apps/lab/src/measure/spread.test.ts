import { expect, it } from 'vitest';
import { median, quantile, spreadOf } from './spread';

const upTo = (most: number): number[] => Array.from({ length: most + 1 }, (_, i) => i);

it('a quantile lies between the values, in any order', () => {
  expect([0, 0.1, 0.25, 0.5, 0.9, 1].map((q) => quantile([3, 1, 2, 5, 4], q))).toEqual([1, 1.4, 2, 3, 4.6, 5]);
  expect([median([7]), median([2, 8]), median([])]).toEqual([7, 5, Number.NaN]);
});

it('a spread is the median of the turns’ medians between the 10th and 90th percentile of all samples', () => {
  expect(spreadOf([upTo(100)])).toEqual({ median: 50, low: 10, high: 90, samples: 101 });
  // one disturbed turn of three does not move the median, and shows in the bounds
  expect(spreadOf([[1, 2, 3], [], [2, 2, 2], [90, 100, 110]])).toEqual({
    ...{ median: 2, low: 1.8, samples: 9 },
    high: expect.closeTo(102, 9),
  });
  expect([spreadOf([]), spreadOf([[], []])]).toEqual([null, null]);
});
