import { expect, test } from 'vitest';
import { madeUpRun } from './madeUpRun';
import { geometricMean, ratiosOf } from './ratios';

test('ratios are of the same cases alone, their mean is geometric', () => {
  const base = madeUpRun([10, 100], { deferred: [1, 2], forward: [2, 'Lost its context.'] });
  const run = madeUpRun([100, 1000, 10], { deferred: [4, 8, 8], forward: [9, 9, 4] });
  const ratios = ratiosOf(run, base, 'frame');
  expect(ratios.map(({ competitor, of, ratio }) => [competitor, of.labCase.lights, ratio])).toEqual([
    ['deferred', 100, 2],
    ['forward', 10, 2],
    ['deferred', 10, 8],
  ]);
  expect(geometricMean(ratios.map(({ ratio }) => ratio))).toBeCloseTo(32 ** (1 / 3), 12);
});

test('runs of one machine tie; other cases and missing metrics have no ratio', () => {
  const [a, b] = [madeUpRun([10], { deferred: [1] }), madeUpRun([10], { deferred: [1.02] })];
  expect(ratiosOf(b, a, 'frame')).toMatchObject([{ ratio: 1.02, isTie: true }]);
  expect(ratiosOf(madeUpRun([20], { deferred: [1] }), a, 'frame')).toEqual([]);
  expect(ratiosOf(a, b, 'gpu')).toEqual([]);
});
