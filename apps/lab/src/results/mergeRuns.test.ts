import { describe, expect, it } from 'vitest';
import type { Effort } from '../plan/LabPlan';
import { planOf } from '../plan/planOf';
import { presets } from '../plan/presets';
import type { Progress } from '../run/Progress';
import { runPlan } from '../run/runPlan';
import type { Stage } from '../stage/Stage';
import { mergeRuns, remainingPlan } from './mergeRuns';
import { testRow, testRun } from './testing/testRun';

const whole = testRun();

/** Runs the atrium under 10 and 100 lights by two competitors, in a stage without frames. */
function measured(effort: Partial<Effort>, onProgress: (progress: Progress) => unknown, signal: AbortSignal) {
  const { configuration } = presets.lights;
  const series = [{ ...configuration.series[0], values: [10, 100] }];
  const competitors = ['forward', 'deferred'];
  const plan = planOf({ ...configuration, series, competitors, effort: { ...configuration.effort, ...effort } });
  const picture = { width: 1, height: 1, data: new Uint8ClampedArray(4) } as ImageData;
  const stage = {
    open: async () => ({ firstMs: 1, dropped: 0, technique: null, reason: null, picture }),
    turn: async () => ({ frame: [1], cpu: [1], gpu: null }),
    count: async () => null,
    passes: async () => null,
    close: () => {},
    unavailable: async () => null,
  } as unknown as Stage;
  let clock = 0;
  const frames = { stageOf: async () => stage, close: () => {} };
  const { surroundings } = whole;
  const options = { frames, surroundings, signal, thumbnailOf: () => '', now: () => (clock += 0.1) };
  return runPlan(plan, { ...options, onProgress: (progress) => void onProgress(progress) });
}

describe('remainingPlan', () => {
  it('has the cases that some competitor lacks, each with its value, and no empty series', () => {
    const rest = remainingPlan({ ...whole, rows: whole.rows.slice(0, 3) });
    expect(rest.series.map(({ name, values }) => [name, values])).toEqual([
      ['planes-lights', [100]],
      ['sponza-pixels', [230_400]],
    ]);
    expect(rest.series[0].cases).toEqual([whole.plan.series[0].cases[1]]);
    expect(rest.competitors).toEqual(whole.plan.competitors);
  });

  it('is empty once every row is there', () => {
    expect(remainingPlan(whole).series).toEqual([]);
  });

  it('has the case at work when the run ended early, whose turns may be fewer', () => {
    const rows = whole.rows.slice(0, 4);
    const { series } = remainingPlan({ ...whole, rows, complete: false });
    expect(series.map(({ values }) => values)).toEqual([[100], [230_400]]);
  });

  it('has cases of which a row says that its time was over', () => {
    const problem = 'Not measured: the run’s limit of 80 s was reached.';
    const rows = whole.rows.with(1, { ...whole.rows[1], frame: null, problem });
    expect(remainingPlan({ ...whole, rows }).series.map(({ values }) => values)).toEqual([[4]]);
    // a row with a permanent problem is not measured again
    const refused = whole.rows.with(1, { ...whole.rows[1], frame: null, problem: 'Too many lights.' });
    expect(remainingPlan({ ...whole, rows: refused }).series).toEqual([]);
  });

  it('has what a cancelled run of the Lab left', async () => {
    const cancel = new AbortController();
    const run = await measured({}, ({ labCase }) => labCase.lights === 100 && cancel.abort(), cancel.signal);
    expect(run.rows.map(({ problem }) => problem)).toEqual([null, null, expect.stringMatching(/^Cancelled/)]);
    expect(remainingPlan(run).series.map(({ values }) => values)).toEqual([[100]]);
  });

  it('has what a run of the Lab left when its time was over', async () => {
    const run = await measured({ limit: 1 }, () => {}, new AbortController().signal);
    expect(run.complete).toBe(false);
    expect(remainingPlan(run).series.map(({ values }) => values)).toEqual([[100]]);
  });
});

describe('mergeRuns', () => {
  it('makes the whole run of a part that ended early and of what remained', () => {
    const early = testRun({ rows: whole.rows.slice(0, 3), complete: false, duration: 4000 });
    const plan = remainingPlan(early);
    // in the plan of the remainder the case of 100 lights has index 0
    const rows = [
      testRow('forward', 'planes-lights', 0, 21),
      testRow('deferred', 'planes-lights', 0, 4),
      testRow('forward', 'sponza-pixels', 0, 8),
      testRow('deferred', 'sponza-pixels', 0, 3),
    ];
    const rest = testRun({ id: 'later', name: '', plan, rows, duration: 5000 });
    const merged = mergeRuns(whole.plan, [early, rest]);
    // the second measurement replaces the first
    const expected = whole.rows.with(2, testRow('forward', 'planes-lights', 1, 21));
    expect(merged).toEqual({ ...whole, rows: expected });
  });

  it('says that cases are missing', () => {
    const merged = mergeRuns(whole.plan, [testRun({ rows: whole.rows.slice(1) })]);
    expect(merged.complete).toBe(false);
    expect(merged.rows).toHaveLength(5);
  });

  it('refuses parts of another device, another plan or none', () => {
    const elsewhere = testRun({ surroundings: { ...whole.surroundings, device: 'Other' } });
    expect(() => mergeRuns(whole.plan, [elsewhere, whole])).toThrow(/device is "Other" and "ANGLE/);
    const { plan } = testRun();
    const smaller = { ...plan, series: plan.series.slice(1) };
    expect(() => mergeRuns(smaller, [whole])).toThrow(/forward in case 0 of planes-lights is not in the plan/);
    expect(() => mergeRuns(whole.plan, [])).toThrow(/nothing to merge/);
  });
});
