import { Matrix4, OrthographicCamera, PerspectiveCamera, Vector4 } from 'three';
import { describe, expect, it, test } from 'vitest';
import { farthestTold, isPlainProjection, needsStoredDistance } from './depthLimits';

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
    const orthographic = (far: number) => new OrthographicCamera(-1, 1, 1, -1, 0, far).projectionMatrix.elements;
    expect(needsStoredDistance(orthographic(1e3), false)).toBe(false);
    expect(needsStoredDistance(orthographic(1e6), false)).toBe(true);
  });
});

test('plain projections are those whose pixels have a place by depth: off-centre or oblique, not skewed, without a view', () => {
  const frustum = new PerspectiveCamera(50, 1.5, 0.1, 100);
  frustum.setViewOffset(400, 300, 20, 30, 100, 80);
  const box = new OrthographicCamera(-1, 3, 2, -1, -5, 20).projectionMatrix;
  const oblique = frustum.projectionMatrix.clone();
  oblique.elements[2] = oblique.elements[6] = 0.3;
  expect(isPlainProjection(frustum.projectionMatrix.elements, false)).toBe(true);
  expect(isPlainProjection(oblique.elements, false)).toBe(true);
  expect(isPlainProjection(box.elements, true)).toBe(true);
  // an orthographic projection on a camera that is no OrthographicCamera
  expect(isPlainProjection(box.elements, false)).toBe(false);
  expect(isPlainProjection(frustum.projectionMatrix.elements, true)).toBe(false);
  const turned = new Matrix4().makeRotationY(0.3);
  const sheared = new Matrix4().makeShear(0, 0, 0, 0, 0.2, 0.1);
  for (const view of [turned, new Matrix4().makeTranslation(0, 1, 2), new Matrix4().makeShear(0, 0.1, 0, 0, 0, 0)])
    expect(isPlainProjection(frustum.projectionMatrix.clone().multiply(view).elements, false)).toBe(false);
  expect(isPlainProjection(box.clone().multiply(sheared).elements, true)).toBe(false);
});
