import { expect, test } from 'vitest';
import { machineSlowness } from './machineSlowness.mjs';

/** A machine that needs these times (s), one after the other. */
const machine = (times: readonly number[]): (() => number) => {
  let i = 0;
  return () => times[i++];
};

test('a machine as fast as the reference, or faster, gets no more time; a slower one as much more as its median', () => {
  expect(machineSlowness(machine([0.01, 0.02, 0.015]))).toBe(1);
  expect(machineSlowness(machine([9, 0.6, 0.6])) / machineSlowness(machine([1.2, 9, 0]))).toBe(0.5);
});
