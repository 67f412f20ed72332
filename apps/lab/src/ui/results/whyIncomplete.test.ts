import { expect, test } from 'vitest';
import { testRow, testRun } from '../../results/testing/testRun';
import { isEmptyRun, whyIncomplete } from './whyIncomplete';

const run = testRun({ complete: false, duration: 9000 });
const withLimit = (limit: number) => ({ ...run, plan: { ...run.plan, effort: { ...run.plan.effort, limit } } });

test('a complete run lacks nothing', () => expect(whyIncomplete({ ...run, complete: true })).toBeNull());

test('a run that was cancelled before its first figure is told apart', () => {
  const row = { ...testRow('auto', 'planes-lights', 0, 1), frame: null, problem: 'Cancelled.' };
  expect(isEmptyRun({ ...run, rows: [row] })).toBe(true);
  expect(isEmptyRun({ ...run, rows: [...run.rows, row] })).toBe(false);
  // a row of a competitor that cannot draw here does not count as a figure
  const none = { ...row, competitor: 'three-webgpu', problem: 'No WebGPU.' };
  expect(whyIncomplete({ ...run, rows: [none, row] })).toMatch(/cancelled before anything was measured/);
  expect(isEmptyRun({ ...run, rows: [{ ...row, problem: 'Not measured: the time is over.' }] })).toBe(false);
  expect(whyIncomplete({ ...run, rows: [row] })).toBe(
    'This run was cancelled before anything was measured, and is not kept.',
  );
});

test('a run is cancelled, or its time is over', () => {
  expect(whyIncomplete(run)).toMatch(/cancelled/);
  expect(whyIncomplete(withLimit(10_000))).toMatch(/cancelled/);
  expect(whyIncomplete(withLimit(9000))).toMatch(/time for the run was over/);
  const late = {
    ...testRow('stock', 'planes-lights', 0, 1),
    frame: null,
    problem: 'Not measured: the run may take 8 s.',
  };
  expect(whyIncomplete({ ...withLimit(10_000), rows: [...run.rows, late] })).toMatch(/time for the run was over/);
});
