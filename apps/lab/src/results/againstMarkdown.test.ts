import { expect, it } from 'vitest';
import { againstMarkdown } from './againstMarkdown';
import { testRow, testRun } from './testRun';

it('compares two builds of one run by Farol’s competitors, case by case and by their mean', () => {
  const run = testRun();
  run.plan = { ...run.plan, competitors: ['forward', 'forward@against', 'stock'] };
  run.rows = [
    ...[testRow('forward', 'planes-lights', 0, 1), testRow('forward@against', 'planes-lights', 0, 2)],
    ...[testRow('forward', 'planes-lights', 1, 8), testRow('forward@against', 'planes-lights', 1, 4)],
    testRow('stock', 'planes-lights', 1, 9),
  ];
  run.surroundings.versions.against = 'HEAD~1';
  const lines = againstMarkdown(run).trim().split('\n');
  expect(lines[0]).toBe('## This build against HEAD~1');
  // GPU time, half of the frame in these rows
  expect(lines.slice(-3)).toEqual([
    '| Planes 1 × 1 over point lights, 4 lights | Farol: forward | 0.5 | 1 | 0.5 |',
    '| Planes 1 × 1 over point lights, 100 lights | Farol: forward | 4 | 2 | 2 |',
    '| geometric mean of 2 cases | Farol: forward | | | **1** |',
  ]);
});

it('has nothing to say of one build alone', () => {
  expect(againstMarkdown(testRun())).toBe('');
});
