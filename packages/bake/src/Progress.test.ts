import { expect, it } from 'vitest';
import type { BakeProgress } from './BakeProgress';
import { Progress } from './Progress';

it('never falls, and tells the seconds that are left by the pace so far', () => {
  const told: BakeProgress[] = [];
  const progress = new Progress((each) => told.push(each));
  progress.report('unwrapping', 0.5);
  progress.report('unwrapping', 0.2);
  progress.report('tracing', 0);
  progress.report('tracing', 0.5, 64);
  progress.report('finishing', 1);
  expect(told.map(({ share }) => share)).toEqual([0.05, 0.05, 0.15, 0.56, 1].map((share) => expect.closeTo(share, 5)));
  expect(told.map(({ secondsLeft }) => secondsLeft)).toEqual([null, null, null, expect.closeTo(0, 1), 0]);
  expect(told[3].samples).toBe(64);
});
