import { expect, it } from 'vitest';
import { TriangleRuns } from './TriangleRuns';

it('TriangleRuns joins what follows, in bytes and indices, and grows', () => {
  const runs = new TriangleRuns();
  runs.add(0, 192);
  runs.add(192, 12);
  runs.add(300, 6);
  expect([...runs.starts.slice(0, runs.count)]).toEqual([0, 1200]);
  expect([...runs.counts.slice(0, runs.count)]).toEqual([204, 6]);
  runs.clear();
  for (let i = 0; i < 100; i++) runs.add(i * 10, 3);
  expect(runs.count).toBe(100);
  expect(runs.starts[99]).toBe(3960);
  expect(runs.counts[50]).toBe(3);
});
