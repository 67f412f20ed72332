import { OrthographicCamera, PerspectiveCamera, Vector4 } from 'three';
import { describe, expect, it } from 'vitest';
import { farthestTold, needsStoredDistance } from './depthLimits';

const perspective = (near: number, far: number) => new PerspectiveCamera(50, 1, near, far).projectionMatrix.elements;

function depthAt(m: ArrayLike<number>, distance: number): number {
  const clip = new Vector4(0, 0, -distance, 1);
  const z = m[10] * clip.z + m[14];
  return 0.5 + (0.5 * z) / (m[11] * clip.z + m[15]);
}

describe('the distance from which depth may be 1', () => {
  it.each([
    [0.1, 1000],
    [0.001, 1e5],
    [1e-6, 50],
    [1, 2],
  ])('is where some steps of depth are left, near %d, far %d', (near, far) => {
    const m = perspective(near, far);
    const told = farthestTold(m, false, 0, false);
    expect(told).toBeGreaterThan(near);
    expect(told).toBeLessThan(far);
    expect((1 - depthAt(m, told)) * 2 ** 22).toBeCloseTo(1, 2);
    expect(farthestTold(m, false, 0, true)).toBeLessThan(told);
  });

  it('is near the far plane of an orthographic camera', () => {
    const m = new OrthographicCamera(-1, 1, 1, -1, -5, 20).projectionMatrix.elements;
    const told = farthestTold(m, false, 0, false);
    expect((1 - depthAt(m, told)) * 2 ** 22).toBeCloseTo(1, 2);
  });

  it('is none where depth is reversed, and any where the near plane is oblique', () => {
    expect(farthestTold(perspective(0.1, 100), true, 0, false)).toBe(Infinity);
    const m = [...perspective(0.1, 100)];
    m[2] = 0.3;
    expect(farthestTold(m, false, 0, false)).toBe(-Infinity);
    expect(needsStoredDistance(m, true)).toBe(true);
  });
});

describe('surfaces store how far they are', () => {
  it('where near and far plane are far apart, or the far plane is nowhere', () => {
    expect(needsStoredDistance(perspective(0.1, 2000), false)).toBe(false);
    expect(needsStoredDistance(perspective(0.001, 1e5), false)).toBe(true);
    expect(needsStoredDistance(perspective(0.001, 1e5), true)).toBe(false);
    expect(needsStoredDistance(perspective(1e-6, 50), false)).toBe(true);
    const endless = [...perspective(0.1, 100)];
    endless[10] = -1;
    endless[14] = -0.2;
    expect(needsStoredDistance(endless, false)).toBe(true);
    expect(needsStoredDistance(new OrthographicCamera(-1, 1, 1, -1, 0, 1e6).projectionMatrix.elements, false)).toBe(
      false,
    );
  });
});
