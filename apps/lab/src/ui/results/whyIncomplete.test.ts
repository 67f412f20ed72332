import { expect, test } from 'vitest';
import { testRow, testRun } from '../../results/testRun';
import { whyIncomplete } from './whyIncomplete';

const run = testRun({ complete: false, duration: 9000 });
const withLimit = (limit: number) => ({ ...run, plan: { ...run.plan, effort: { ...run.plan.effort, limit } } });

test('a complete run lacks nothing', () => expect(whyIncomplete({ ...run, complete: true })).toBeNull());

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
