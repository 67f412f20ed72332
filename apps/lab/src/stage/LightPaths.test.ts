import { Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { type LightPath, LightPaths } from './LightPaths';

const path: LightPath = { place: [1, 2, 3], extent: [2, 0.5, 0], speed: 1.5, seed: 7 };

/** Position of the second of two lights at a time (s). */
function at(seconds: number, changes: Partial<LightPath> = {}): Vector3 {
  const position = new Vector3();
  new LightPaths([
    { ...path, seed: 99, place: [0, 0, 0] },
    { ...path, ...changes },
  ]).place(1, seconds, position);
  return position;
}

describe('LightPaths', () => {
  it('begins at the place, and moves within the extent and below the speed', () => {
    expect(at(0).toArray()).toEqual([1, 2, 3]);
    let longest = 0;
    for (let seconds = 0; seconds < 60; seconds += 0.05) {
      const { x, y, z } = at(seconds);
      expect(Math.abs(x - 1)).toBeLessThanOrEqual(2);
      expect(Math.abs(y - 2)).toBeLessThanOrEqual(0.5);
      expect(z).toBe(3);
      const next = at(seconds + 0.001);
      longest = Math.max(longest, Math.abs(next.x - x), Math.abs(next.y - y));
    }
    // 1.5 m/s for a thousandth of a second; the next line checks that the light moves
    expect(longest).toBeLessThanOrEqual(0.0015);
    expect(longest).toBeGreaterThan(0.0005);
  });

  it('is the same in every run, and another one by another seed', () => {
    expect(at(3.7)).toEqual(at(3.7));
    expect(at(3.7).distanceTo(at(3.7, { seed: 8 }))).toBeGreaterThan(0.01);
  });
});
