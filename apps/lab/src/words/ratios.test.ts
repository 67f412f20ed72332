import { expect, test } from 'vitest';
import { madeUpRun } from './madeUpRun';
import { ratiosOf, ratioWords } from './ratios';

test('ratios are of the same cases alone, their mean is geometric', () => {
  const base = madeUpRun([10, 100], { deferred: [1, 2], forward: [2, 'Lost its context.'] });
  const run = madeUpRun([100, 1000, 10], { deferred: [4, 8, 8], forward: [9, 9, 4] });
  const ratios = ratiosOf(run, base, 'frame');
  expect(ratios.map(({ competitor, of, ratio }) => [competitor, of.labCase.lights, ratio])).toEqual([
    ['deferred', 100, 2],
    ['forward', 10, 2],
    ['deferred', 10, 8],
  ]);
  expect(ratioWords(ratios.slice(0, 2), 'B', 'A')).toEqual([
    'B takes 2 times as long as A, over 2 figures (geometric mean).',
    'Least: deferred, 2 times; most: forward, 2 times.',
  ]);
  expect(ratioWords(ratios, 'B', 'A')[0]).toContain('3.2 times');
});

test('runs of one machine tie, and runs without a common case say so', () => {
  const [a, b] = [madeUpRun([10], { deferred: [1] }), madeUpRun([10], { deferred: [1.02] })];
  expect(ratioWords(ratiosOf(b, a, 'frame'), 'B', 'A')).toEqual([
    'B takes 1.02 times as long as A, over one figure (geometric mean).',
    'No figure differs by more than the spread.',
  ]);
  expect(ratioWords(ratiosOf(madeUpRun([20], { deferred: [1] }), a, 'frame'), 'B', 'A')).toEqual([
    'B and A have no case in common.',
  ]);
  expect(ratiosOf(a, b, 'gpu')).toEqual([]);
});
