import { expect, test } from 'vitest';
import type { LabRun } from '../results/LabRun';
import { madeUpRun } from '../words/testing/madeUpRun';
import { defaultSettings } from './ChartSpec';
import { paintOf } from './chartPaint';
import { ratioChart } from './ratioChart';

const chartOf = (run: LabRun, base: LabRun, metric: 'frame' | 'gpu' = 'frame') =>
  ratioChart([base, 'A'], [run, 'B'], { ...defaultSettings, metric });

test('ratios are of the same cases alone, their mean is geometric', () => {
  const base = madeUpRun([10, 100], { deferred: [1, 2], forward: [2, 'Lost its context.'] });
  const run = madeUpRun([100, 1000, 10], { deferred: [4, 8, 8], forward: [9, 9, 4] });
  const chart = chartOf(run, base)!;
  expect(chart.table.rows.map((row) => row.slice(0, 3))).toEqual([
    ['Made up, 100 lights', 'Farol: deferred', '2'],
    ['Made up, 10 lights', 'Farol: deferred', '8'],
    ['Made up, 10 lights', 'Farol: forward', '2'],
  ]);
  const { points } = chart.draw({ width: 600, paint: paintOf('light') });
  expect(points.at(-1)!.tip.lines).toEqual([
    '4 times as long over 2 figures',
    '2 (Made up, 100 lights) to 8 (Made up, 10 lights)',
  ]);
});

test('runs of one machine tie; other cases and missing metrics have no chart', () => {
  const [a, b] = [madeUpRun([10], { deferred: [1] }), madeUpRun([10], { deferred: [1.02] })];
  expect(chartOf(b, a)!.table.rows[0].slice(2)).toEqual(['1.02', '1.02 to 1.02', 'yes']);
  expect(chartOf(madeUpRun([20], { deferred: [1] }), a)).toBeNull();
  expect(chartOf(a, b, 'gpu')).toBeNull();
});
