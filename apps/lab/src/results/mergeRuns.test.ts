import { describe, expect, it } from 'vitest';
import { mergeRuns, remainingPlan } from './mergeRuns';
import { testRow, testRun } from './testRun';

const whole = testRun();

describe('remainingPlan', () => {
  it('has the cases that some competitor lacks, each with its value, and no empty series', () => {
    const rest = remainingPlan(whole.plan, whole.rows.slice(0, 3));
    expect(rest.series.map(({ name, values }) => [name, values])).toEqual([
      ['planes-lights', [100]],
      ['sponza-pixels', [230_400]],
    ]);
    expect(rest.series[0].cases).toEqual([whole.plan.series[0].cases[1]]);
    expect(rest.competitors).toEqual(whole.plan.competitors);
  });

  it('is empty once every row is there', () => {
    expect(remainingPlan(whole.plan, whole.rows).series).toEqual([]);
  });
});

describe('mergeRuns', () => {
  it('makes the whole run of a part that ended early and of what remained', () => {
    const early = testRun({ rows: whole.rows.slice(0, 3), complete: false, duration: 4000 });
    const plan = remainingPlan(whole.plan, early.rows);
    // in the plan of the remainder the case of 100 lights has index 0
    const rows = [
      testRow('forward', 'planes-lights', 0, 21),
      testRow('deferred', 'planes-lights', 0, 4),
      testRow('forward', 'sponza-pixels', 0, 8),
      testRow('deferred', 'sponza-pixels', 0, 3),
    ];
    const rest = testRun({ id: 'later', name: '', plan, rows, duration: 5000 });
    const merged = mergeRuns(whole.plan, [early, rest]);
    // what was measured once more stands in place of the earlier figure
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
    expect(() => mergeRuns(smaller, [whole])).toThrow(/forward in case 0 of planes-lights is not asked for/);
    expect(() => mergeRuns(whole.plan, [])).toThrow(/No parts/);
  });
});
