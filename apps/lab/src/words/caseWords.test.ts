import { describe, expect, test } from 'vitest';
import { sampleRun } from '../charts/sampleRuns';
import { winnerMaps } from '../charts/winnerMap';
import { changeWords } from './changeWords';
import { exactly, madeUpRow, madeUpRun } from './madeUpRun';
import { mapWords } from './mapWords';
import { missingMetric } from './missingMetric';
import { passTotal, passWords } from './passWords';
import { regretsOf, regretWords } from './regret';
import { winnersOf, winningRanges } from './winners';

const wide = (median: number) => ({ median, low: median * 0.5, high: median * 2, samples: 9 });

describe('regret of auto', () => {
  test('is its time over the best technique’s, not over other renderers’', () => {
    const run = madeUpRun([10, 100], { auto: [1.1, 3], deferred: [1, 4], forward: [2, 2], stock: [0.5, 0.5] });
    run.rows[1].technique = 'deferred';
    const regrets = regretsOf(run, 'frame');
    expect(regrets.map(({ best, regret }) => [best.competitor, Number(regret.toFixed(6))])).toEqual([
      ['deferred', 0.1],
      ['forward', 0.5],
    ]);
    expect(regretWords(regrets)).toEqual([
      'Over 2 cases auto took 30% longer than the best technique on average.',
      'Worst: 50% with Made up, 100 lights (deferred 3 ms, forward 2 ms).',
    ]);
  });

  test('one case alone is not called the worst', () => {
    const run = madeUpRun([10], { auto: [1.5], forward: [1.5], deferred: [1] });
    run.rows[0].technique = 'forward';
    expect(regretWords(regretsOf(run, 'frame'))).toEqual([
      'Auto took 50% longer than the best technique in the one case measured.',
      'It drew by forward: 1.5 ms, deferred 1 ms.',
    ]);
  });

  test('within the spread it is not called a loss', () => {
    const run = madeUpRun([10], { auto: [wide(1.2)], deferred: [wide(1)] });
    expect(regretWords(regretsOf(run, 'frame'))).toEqual([
      'Auto took 20% longer than the best technique in the one case measured.',
      'In no case is it surely slower: the differences are within the spread.',
    ]);
  });

  test('without auto or without techniques there is none', () => {
    expect(regretsOf(madeUpRun([10], { deferred: [1] }), 'frame')).toEqual([]);
    expect(regretsOf(madeUpRun([10], { auto: [1], stock: [1] }), 'frame')).toEqual([]);
    expect(regretWords([])[0]).toContain('were not measured');
  });
});

describe('who wins where', () => {
  test('ties name all, the shortest median first, auto never', () => {
    const run = madeUpRun([10], { auto: [0.1], forward: [1.02], deferred: [1], inferred: [3] });
    const winners = winnersOf(run, run.plan.series[0], 0, 'frame')!;
    expect(winners.names).toEqual(['deferred', 'forward']);
    expect(winners.entries.map(({ competitor }) => competitor)).toEqual(['deferred', 'forward', 'inferred']);
  });

  test('a range goes on while somebody who won its first case wins', () => {
    const run = madeUpRun([1, 2, 3], { forward: [1, 1.01, 9], deferred: [9, 1, 1] });
    const winners = [0, 1, 2].map((index) => winnersOf(run, run.plan.series[0], index, 'frame')!);
    expect(winningRanges(winners).map(({ names, cases }) => [names, cases.length])).toEqual([
      [['forward'], 2],
      [['deferred'], 1],
    ]);
  });

  test('wins and ties are counted', () => {
    const run = madeUpRun([1, 2, 3], { forward: [1, 1, 1], deferred: [2, 1, 3] });
    const winners = [0, 1, 2].map((index) => winnersOf(run, run.plan.series[0], index, 'frame')!);
    expect(mapWords(winners)).toEqual(['Of 3 cases forward wins 2; 1 is a tie within the spread.']);
    expect(mapWords([winners[1]])).toEqual(['In the one case none has one winner: 1 is a tie within the spread.']);
    expect(mapWords([])).toEqual(['Nothing has been measured here yet.']);
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

describe('passes', () => {
  const row = (competitor: string, ...passes: [name: string, ms: number][]) => ({
    ...madeUpRow(competitor, 0, 1),
    passes: { kind: 'gpu' as const, passes: passes.map(([name, ms]) => ({ name, ms })) },
  });

  test('the longest pass of the quickest and the slowest, and the G-buffer', () => {
    const rows = [row('deferred', ['G-buffer', 1], ['lights', 3]), row('inferred', ['G-buffer', 1.5], ['lights', 0.5])];
    expect(passWords(rows)).toEqual([
      'Inferred spends 75% of 2 ms GPU time in “G-buffer”.',
      'Deferred spends 75% of 4 ms GPU time in “lights”: 2 ms more in all than inferred.',
      'G-buffers take 1 ms to 1.5 ms.',
    ]);
  });

  test('times that are no numbers count nothing', () => {
    const broken = row('forward', ['objects', Number.NaN], ['output', 2]);
    expect(passTotal(broken)).toBe(2);
    expect(passWords([broken])).toEqual(['Forward spends 100% of 2 ms GPU time in “output”.']);
    expect(passWords([madeUpRow('forward', 0, 1)])).toEqual(['No times of passes were measured here.']);
  });
});

describe('changes', () => {
  test('who compiles for ten lights more, and how much longer that frame is', () => {
    const stock = { ...madeUpRow('stock', 0, 2), firstMs: 300, added: { ms: 500, programs: 3 } };
    const deferred = { ...madeUpRow('deferred', 0, 2), firstMs: 90, added: { ms: 3, programs: 0 } };
    expect(changeWords([stock, deferred])).toEqual([
      'The first frame takes 90 ms (deferred) to 300 ms (three’s WebGLRenderer).',
      'For ten lights more three’s WebGLRenderer links 3 programs (500 ms, 250 times an ordinary frame); the others link none.',
    ]);
    expect(changeWords([deferred])).toEqual(['Deferred links no program for ten lights more: 3 ms.']);
  });

  test('who is not counted is not said to link none', () => {
    const stock = { ...madeUpRow('stock', 0, 2), added: { ms: 500, programs: 1 } };
    const webgpu = { ...madeUpRow('three-webgpu', 0, 2), added: { ms: 3, programs: null } };
    expect(changeWords([stock, webgpu])).toEqual([
      'For ten lights more three’s WebGLRenderer links one program (500 ms, 250 times an ordinary frame).',
    ]);
    const deferred = { ...madeUpRow('deferred', 0, 2), added: { ms: 3, programs: 0 } };
    expect(changeWords([stock, webgpu, deferred])[0]).toContain('; the others that are counted link none.');
    expect(changeWords([madeUpRow('deferred', 0, 1)])).toEqual(['No frames after changes were measured here.']);
  });
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
