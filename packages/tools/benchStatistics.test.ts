import { describe, expect, it } from 'vitest';
import { median, quantile, spread, summarise } from './benchStatistics.mjs';

describe('quantile', () => {
  it('orders by number and interpolates between neighbours', () => {
    expect(quantile([10, 9, 100], 0.5)).toBe(10);
    expect(quantile([4, 1, 3, 2], 0.5)).toBe(2.5);
    expect(quantile([0, 10], 0.95)).toBeCloseTo(9.5, 12);
    expect(quantile([5], 0.95)).toBe(5);
  });

  it('leaves the values in their order and refuses an empty list', () => {
    const values = [3, 1, 2];
    median(values);
    expect(values).toEqual([3, 1, 2]);
    expect(() => quantile([], 0.5)).toThrow(RangeError);
  });
});

describe('spread', () => {
  it('does not let one disturbed round move the median, and shows it in the p95', () => {
    const { median, p95 } = spread([
      [1, 1, 1],
      [2, 2, 2],
      [90, 90, 90],
    ])!;
    expect(median).toBe(2);
    expect(p95).toBe(90);
  });

  it('goes by the rounds that have values, and is null without any', () => {
    expect(spread([null, [4], []])).toEqual({ median: 4, p95: 4 });
    expect(spread([null, []])).toBeNull();
  });
});

const round = (over: object) => ({
  ...{ renderer: 'r', technique: 'deferred', reason: '', lights: 10, visible: 9, firstMs: 30, batchSize: 20 },
  ...{ gpu: null, cpu: [1], frame: [4], batch: [3], draws: 12, triangles: 100, programs: 7 },
  ...{ uploadBytes: 64, stillUploadBytes: 0, targetBytes: 1000, added: null, removed: null },
  ...over,
});

describe('summarise', () => {
  it('takes the change of lights over an ordinary frame of the same round, and the most programs', () => {
    const { added, removed } = summarise([
      round({ frame: [4], added: { ms: 8, programs: 0, lights: 10 } }),
      round({ frame: [10], added: { ms: 10, programs: 2, lights: 10 } }),
      round({ frame: [1], added: { ms: 3, programs: 0, lights: 10 } }),
    ]);
    expect(added).toEqual({ ms: 8, ratio: 2, programs: 2, lights: 10 });
    expect(removed).toBeNull();
  });

  it('has counts without times', () => {
    const counted = round({ cpu: null, frame: null, batch: null, firstMs: null });
    const summary = summarise([{ ...counted, removed: { ms: null, programs: 1, lights: 3 } }]);
    expect(summary).toMatchObject({ cpu: null, frame: null, firstMs: null, draws: 12, uploadBytes: 64 });
    expect(summary.removed).toEqual({ ms: null, ratio: null, programs: 1, lights: 3 });
  });
});
