import { expect, test } from 'vitest';
import type { LabRow } from '../../results/LabRun';
import { type LabCase, type LabPlan, plainCase } from '../../plan/LabPlan';
import { columnsOf, tableRows } from './rowColumns';
import { sortRows } from './sortRows';

const labCase = (lights: number): LabCase => ({
  ...{ scene: { name: 'sponza', parameters: {} }, lights, shadows: 0, overdraw: 0, width: 1280, height: 720 },
  ...plainCase,
});
const plan: LabPlan = {
  ...{ preset: 'custom', label: 'Custom', competitors: ['stock', 'forward', 'deferred'] },
  series: [{ name: 'sponza', label: 'Atrium', axis: 'lights', cases: [labCase(10), labCase(100)], values: [10, 100] }],
  effort: { rounds: 1, turn: 100, changes: false, longestFrame: 1000, limit: null },
};
const row = (competitor: string, index: number, ms: number | null, series = 'sponza'): LabRow => ({
  ...{ competitor, series, index, cpu: null, gpu: null, firstMs: null, added: null, changed: null },
  ...{ counts: null, passes: null, likeness: null, dropped: 0, technique: null, reason: null },
  frame: ms === null ? null : { median: ms, low: ms, high: ms, samples: 3 },
  ...{ problem: ms === null ? 'No figure.' : null, warnings: [] },
});
const run = {
  plan,
  rows: [row('stock', 1, null), row('stock', 0, 2), row('deferred', 1, 1), row('forward', 1, 5), row('forward', 0, 2)],
};
const ordered = (key: string, isDescending = false): string[] => {
  const rows = tableRows(run);
  return sortRows(rows, columnsOf(rows), { key, isDescending }).map((each) => `${each.competitor} ${each.value}`);
};

test('rows of charts that the plan has not are left out', () => {
  expect(tableRows({ plan, rows: [row('stock', 0, 1, 'temple'), row('stock', 2, 1)] })).toEqual([]);
});

test('the columns are those in which a row has something', () => {
  const keys = columnsOf(tableRows(run)).map(({ key }) => key);
  expect(keys).toEqual(['case', 'value', 'size', 'lights', 'frame']);
});

test('by chart and value first, the competitors in the order of the menu', () => {
  expect(ordered('case')).toEqual(['forward 10', 'stock 10', 'forward 100', 'deferred 100', 'stock 100']);
});

test('by time, rows without one last in both directions', () => {
  expect(ordered('frame')).toEqual(['deferred 100', 'forward 10', 'stock 10', 'forward 100', 'stock 100']);
  expect(ordered('frame', true)).toEqual(['forward 100', 'forward 10', 'stock 10', 'deferred 100', 'stock 100']);
});

test('by competitor', () => {
  expect(ordered('competitor', true)).toEqual(['stock 10', 'stock 100', 'deferred 100', 'forward 10', 'forward 100']);
});
