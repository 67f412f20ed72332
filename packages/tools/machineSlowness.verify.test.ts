import { expect, test } from 'vitest';
import { workSeconds } from './machineSlowness.mjs';

test('the work is done each time, in time that this process works', () => {
  const { user, system } = process.cpuUsage();
  const seconds = workSeconds() + workSeconds();
  const { user: userNow, system: systemNow } = process.cpuUsage();
  expect(seconds).toBeGreaterThan(0);
  expect(seconds * 1e6).toBeLessThanOrEqual(userNow - user + systemNow - system);
});
