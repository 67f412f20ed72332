import { describe, expect, test } from 'vitest';
import { defaultSettings } from '../charts/ChartSpec';
import { passTotal } from '../charts/passChart';
import { regretChart } from '../charts/regretChart';
import { sampleRun } from '../charts/testing/sampleRuns';
import { winnerMaps } from '../charts/winnerMap';
import type { LabRun } from '../results/LabRun';
import { exactly, madeUpRow, madeUpRun } from './testing/madeUpRun';
import { missingMetric } from './compareSpreads';
import { winnersOf } from './winners';

const wide = (median: number) => ({ median, low: median * 0.5, high: median * 2, samples: 9 });

describe('regret of auto', () => {
  const rowsOf = (run: LabRun) => regretChart(run, defaultSettings)?.table.rows;

  test('is its time over the best technique’s, not over other renderers’', () => {
    const run = madeUpRun([10, 100], { auto: [1.1, 3], deferred: [1, 4], forward: [2, 2], stock: [0.5, 0.5] });
    run.rows[1].technique = 'deferred';
    expect(rowsOf(run)).toEqual([
      ['Made up, 10 lights', '–', '1.1', 'Farol: deferred', '1', '10%', 'no'],
      ['Made up, 100 lights', 'Farol: deferred', '3', 'Farol: forward', '2', '50%', 'no'],
    ]);
  });

  test('is marked within the spread, and missing without auto or without techniques', () => {
    expect(rowsOf(madeUpRun([10], { auto: [wide(1.2)], deferred: [wide(1)] }))![0].slice(-2)).toEqual(['20%', 'yes']);
    expect(rowsOf(madeUpRun([10], { deferred: [1] }))).toBeUndefined();
    expect(rowsOf(madeUpRun([10], { auto: [1], stock: [1] }))).toBeUndefined();
  });
});

describe('who wins where', () => {
  test('ties name all, the shortest median first, auto never', () => {
    const run = madeUpRun([10], { auto: [0.1], forward: [1.02], deferred: [1], inferred: [3] });
    const winners = winnersOf(run, run.plan.series[0], 0, 'frame')!;
    expect(winners.names).toEqual(['deferred', 'forward']);
    expect(winners.entries.map(({ competitor }) => competitor)).toEqual(['deferred', 'forward', 'inferred']);
  });

  test('lights by pixels where a scene has several of both, else series by values', () => {
    const [map, ...others] = winnerMaps(sampleRun({ preset: 'resolution' }), 'frame');
    expect(others).toEqual([]);
    expect([map.rows.length, map.columns.length, map.cells.length]).toEqual([4, 2, 8]);
    expect(map.columns).toEqual(['20 lights', '500 lights']);
    const quick = winnerMaps(sampleRun(), 'frame');
    expect(quick.map(({ rows, columns }) => [rows.toSorted(), columns])).toEqual([
      [
        ['Atrium', 'Planes 1 × 1'],
        ['4', '10', '100', '1,000'],
      ],
    ]);
  });
});

test('times of passes that are no numbers count nothing', () => {
  const passes = [
    { name: 'objects', ms: Number.NaN },
    { name: 'output', ms: 2 },
  ];
  expect(passTotal({ ...madeUpRow('forward', 0, 1), passes: { kind: 'gpu', passes } })).toBe(2);
});

test('a metric that is missing says why; a run without rows is not asked', () => {
  const run = madeUpRun([10], { deferred: [1] });
  expect(missingMetric([run], 'frame')).toBeNull();
  expect(missingMetric([run], 'gpu')).toContain('timer');
  expect(missingMetric([{ ...run, rows: [] }], 'gpu')).toBeNull();
  const software = { ...run, surroundings: { ...run.surroundings, device: 'SwiftShader' } };
  expect(missingMetric([software], 'gpu')).toBe('No GPU times: a software rasteriser draws on the processor.');
  run.rows[0].gpu = exactly(1);
  expect(missingMetric([run], 'gpu')).toBeNull();
});
