import { Matrix4 } from 'three';
import { expect, test } from 'vitest';
import { particleDefaults } from './particleDefaults';
import { PendingSteps } from './PendingSteps';

test.each(['restart', 'done'] as const)('what was kept for long is let go: %s', (end) => {
  const pending = new PendingSteps();
  const matrix = new Matrix4();
  pending.restart(matrix);
  pending.advance(60, { ...particleDefaults, life: [60, 60] }, matrix, true);
  expect(pending.count).toBe(1800);
  if (end === 'restart') pending.restart(matrix);
  else pending.done();
  expect(pending.count).toBe(0);
  expect(pending.steps.length).toBeLessThanOrEqual(64);
  // later steps are still added
  pending.advance(10, particleDefaults, matrix, true);
  expect(pending.count).toBeGreaterThan(64);
  expect(pending.steps[pending.count - 1].time).toBeCloseTo(end === 'done' ? 70 : 10, 6);
});
