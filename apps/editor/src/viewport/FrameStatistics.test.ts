import { expect, it } from 'vitest';
import { FrameStatistics } from './FrameStatistics';

it('gives the rate of steady frames, and none once they have stopped', () => {
  const statistics = new FrameStatistics();
  expect(statistics.rate(0)).toBeNull();
  for (let i = 0; i <= 100; i++) statistics.add(1000 + i * 20);
  expect(statistics.rate(3000)).toBeCloseTo(50, 6);
  expect(statistics.rate(3501)).toBeNull();
});

it('does not count a time without frames as a slow frame', () => {
  const statistics = new FrameStatistics();
  for (const now of [0, 10, 20, 5000, 5010, 5020]) statistics.add(now);
  expect(statistics.rate(5020)).toBeCloseTo(100, 6);
});
