import { expect, it } from 'vitest';
import type { LabRow, LabRun } from './benchLabBrowser.mjs';
import { doubtfulPlan, figuresTable, reachedText, regretReport, slowerCases } from './benchVerdict.mjs';

/** A row by its times (ms): of a frame, on the CPU, on the GPU. */
function row(competitor: string, index: number, [frame, cpu, gpu]: number[], technique: string | null = null): LabRow {
  return {
    ...{
      competitor,
      series: 'sponza-lights',
      index,
      technique,
      firstMs: 90,
      likeness: null,
      problem: null,
      warnings: [],
    },
    ...{ frame: { median: frame }, cpu: { median: cpu }, gpu: { median: gpu }, counts: { draws: 4901, programs: 2 } },
  };
}

function runOf(rows: LabRow[]): LabRun {
  const series = {
    ...{ name: 'sponza-lights', label: 'Atrium over point lights', axis: 'lights' },
    ...{ values: [10, 1000], cases: [{}, {}] },
  };
  const competitors = [...new Set(rows.map(({ competitor }) => competitor))];
  return {
    ...{ name: '', rows, complete: true },
    plan: { label: 'Regression', series: [series], competitors, effort: { rounds: 5 } },
    surroundings: {
      date: '2026-11-27',
      device: 'H100',
      browser: 'Chromium',
      build: '0.1.0',
      command: 'npm run bench -- --gpu --dist ../x/now --write',
    },
  };
}

it('finds what is slower: on the GPU by more than 2%, on the CPU by more than 5%, beyond a step of the clock', () => {
  const run = runOf([
    row('auto', 0, [1, 0.104, 1.019]),
    row('auto@against', 0, [1, 0.1, 1]), // the CPU by 4%, the GPU by 1.9%
    row('auto', 1, [7, 1.06, 7.2]),
    row('auto@against', 1, [7, 1, 7]), // both
    row('deferred', 1, [1, 0.01, 1]),
    row('deferred@against', 1, [1, 0.006, 1]), // by 67%, which is 4 µs
    row('stock', 1, [9, 9, 9]),
  ]);
  const slower = slowerCases(run);
  expect(slower.map(({ name, competitor, what }) => [name, competitor, what])).toEqual([
    ['Atrium over point lights, 1,000 lights', 'auto', 'GPU'],
    ['Atrium over point lights, 1,000 lights', 'auto', 'CPU'],
  ]);
  const again = doubtfulPlan(run.plan, slower);
  expect(again.series).toMatchObject([{ values: [1000], cases: [{}] }]);
  expect(again.competitors).toEqual(['auto', 'auto@against']);
  expect(again.effort.rounds).toBe(10);
});

it('prints each figure with the other build’s, its ratio, and what was reached', () => {
  const run = runOf([row('auto', 1, [7, 1.5, 6.5], 'tiled-deferred'), row('auto@against', 1, [7, 1, 13])]);
  const reached = JSON.parse(reachedText(run, null));
  expect(reached).toMatchObject({ device: 'H100', command: 'npm run bench -- --gpu --write' });
  expect(reached.cases).toEqual({ 'Atrium over point lights, 1,000 lights: auto': [7, 1.5, 6.5, 4901, 2, 90] });
  expect(figuresTable(run, reached).split('\n').at(-1)).toBe(
    '| Atrium over point lights, 1,000 lights | auto (tiled-deferred) | 7 / 7 (1.000) | 1.50 / 1 (1.500) | ' +
      '6.50 / 13 (0.500) | 4901 / 4901 (1.000) | 2 / 2 (1.000) | 90 / 90 (1.000) | 7, 1.50, 6.50 |',
  );
});

it('writes no figure that is doubtful', () => {
  const [spoiled, sound] = [row('auto', 0, [1, 1, 1]), row('deferred', 0, [1, 1, 1])];
  spoiled.warnings.push('The last turn was 47% faster than the first.');
  expect(Object.keys(JSON.parse(reachedText(runOf([spoiled, sound]), null)).cases)).toEqual([
    'Atrium over point lights, 10 lights: deferred',
  ]);
});

it('keeps what was reached in other cases of the same device, and nothing of another', () => {
  const run = runOf([row('auto', 0, [1, 1, 1])]);
  const before = JSON.parse(reachedText(runOf([row('auto', 1, [2, 2, 2])]), null));
  expect(Object.keys(JSON.parse(reachedText(run, before)).cases)).toHaveLength(2);
  expect(Object.keys(JSON.parse(reachedText(run, { ...before, device: 'H200' })).cases)).toHaveLength(1);
});

it('tells what auto loses, apart for cases bound by the CPU and by the GPU', () => {
  const run = runOf([
    row('auto', 0, [1, 0.9, 0.5], 'clustered-deferred'),
    row('clustered-deferred', 0, [1.01, 0.9, 0.5]),
    row('tiled-deferred', 0, [1, 0.9, 0.5]),
    row('auto', 1, [7.2, 1, 7], 'clustered-deferred'),
    row('clustered-deferred', 1, [7.1, 1, 7]),
    row('tiled-deferred', 1, [6.7, 1, 7]),
  ]);
  const { text, isWithin } = regretReport(run);
  expect(text).toContain('Bound by the CPU: 1 cases, mean 0.0%, worst 0.0%');
  // by the lesser of auto's time and its technique's
  expect(text).toContain('Bound by the GPU: 1 cases, mean 6.0%, worst 6.0%');
  expect(isWithin).toBe(false);
});
