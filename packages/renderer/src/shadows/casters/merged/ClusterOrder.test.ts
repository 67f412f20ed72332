import { describe, expect, it } from 'vitest';
import { CLUSTER_TRIANGLES, ClusterOrder } from './ClusterOrder';

function random(seed: number): () => number {
  let state = seed;
  return () => (state = (state * 16807) % 2147483647) / 2147483647;
}

function spread(count: number): Float32Array {
  const next = random(7);
  return Float32Array.from({ length: count * 3 }, () => next() * 10);
}

describe('ClusterOrder', () => {
  it('keeps every triangle once, whatever the steps', () => {
    const centres = spread(1000);
    const whole = new ClusterOrder(centres);
    whole.step(Infinity);
    const steps = new ClusterOrder(centres);
    let count = 0;
    while (!steps.isDone) {
      steps.step(100);
      count++;
    }
    expect(count).toBeGreaterThan(5);
    expect([...steps.order]).toEqual([...whole.order]);
    expect([...whole.order].sort((a, b) => a - b)).toEqual(Array.from({ length: 1000 }, (_, i) => i));
  });

  it('puts close together what lies close together: a row as long as a cluster where it came so, a patch now', () => {
    // 64 rows of 64: in their own order each cluster is a row of 64 by 1
    const centres = new Float32Array(64 * 64 * 3);
    for (let i = 0; i < 64 * 64; i++) centres.set([i % 64, 0, Math.floor(i / 64)], i * 3);
    const clusters = new ClusterOrder(centres);
    clusters.step(Infinity);
    for (let first = 0; first < 64 * 64; first += CLUSTER_TRIANGLES) {
      const own = [...clusters.order.subarray(first, first + CLUSTER_TRIANGLES)];
      for (const axis of [0, 2]) {
        const values = own.map((triangle) => centres[triangle * 3 + axis]);
        expect(Math.max(...values) - Math.min(...values)).toBe(7);
      }
    }
  });

  it('halves at whole clusters, and ends with equal centres', () => {
    const clusters = new ClusterOrder(new Float32Array(1000 * 3));
    clusters.step(Infinity);
    expect(clusters.isDone).toBe(true);
    expect(new Set(clusters.order).size).toBe(1000);
  });
});
