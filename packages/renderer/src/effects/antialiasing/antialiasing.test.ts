import { Matrix4, OrthographicCamera, PerspectiveCamera, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { halton } from './halton';
import { jitterProjection, TAA } from './TAA';

describe('halton', () => {
  it('is the radical inverse', () => {
    expect([1, 2, 3, 4].map((i) => halton(i, 2))).toEqual([0.5, 0.25, 0.75, 0.125]);
    expect(halton(5, 3)).toBeCloseTo(2 / 3 + 1 / 9, 12);
  });

  it('has the middle for its mean, so that a picture is not moved', () => {
    for (const base of [2, 3]) {
      const mean = Array.from({ length: 32 }, (_, i) => halton(i + 1, base)).reduce((a, b) => a + b) / 32;
      expect(Math.abs(mean - 0.5), `base ${base}`).toBeLessThan(0.03);
    }
  });
});

describe('jitterProjection', () => {
  const cameras = [new PerspectiveCamera(50, 1.5, 0.1, 100), new OrthographicCamera(-3, 3, 2, -2, 0.1, 100)];
  it.each(cameras)('moves every point of the picture alike, whatever its depth: $type', (camera) => {
    camera.setViewOffset(300, 200, 20, 10, 200, 150);
    const moved = jitterProjection(new Matrix4().copy(camera.projectionMatrix), 0.25, -0.125);
    for (const point of [new Vector3(0.3, 0.2, -1), new Vector3(-2, 1, -40)]) {
      const before = point.clone().applyMatrix4(camera.projectionMatrix);
      const after = point.clone().applyMatrix4(moved);
      expect(after.x - before.x).toBeCloseTo(0.25, 10);
      expect(after.y - before.y).toBeCloseTo(-0.125, 10);
      expect(after.z).toBeCloseTo(before.z, 10);
    }
  });
});

describe('TAA', () => {
  it('refuses a number of cells that it cannot have', () => {
    expect(() => new TAA({ cells: 3 as 2 })).toThrow('TAA: cells is 3; give 1 or 2.');
    expect(() => new TAA({ cells: 1 })).not.toThrow();
  });
});
