import { describe, expect, it } from 'vitest';
import { projectedSphereBounds } from './projection';
import { createRandom, perspective, project, randomDirection, randomSpheres, testCameras } from './testing/testScenes';

const bounds = new Float64Array(4);
const STEPS = 2000;

/** Rectangle of sampled points of the sphere's outline in the planes that hold its extremes, between near and far. */
function sampledBounds(
  x: number,
  y: number,
  z: number,
  r: number,
  m: readonly number[],
  near: number,
  far: number,
): number[] {
  const sampled = [Infinity, Infinity, -Infinity, -Infinity];
  const take = (px: number, py: number, pz: number) => {
    const depth = Math.min(far, Math.max(near, -pz));
    if (Math.abs(depth + pz) > 1e-9 * Math.max(1, Math.abs(pz))) return;
    const [u, v] = project(m, px, py, -depth);
    sampled[0] = Math.min(sampled[0], u);
    sampled[1] = Math.min(sampled[1], v);
    sampled[2] = Math.max(sampled[2], u);
    sampled[3] = Math.max(sampled[3], v);
  };
  for (let i = 0; i < STEPS; i++) {
    const angle = (i / STEPS) * 2 * Math.PI;
    take(x + r * Math.cos(angle), y, z + r * Math.sin(angle));
    take(x, y + r * Math.cos(angle), z + r * Math.sin(angle));
  }
  for (const plane of [near, far]) {
    const half = Math.sqrt(r * r - (plane + z) ** 2);
    if (!(half >= 0)) continue;
    for (const side of [-half, half]) {
      take(x + side, y, -plane);
      take(x, y + side, -plane);
    }
  }
  return sampled;
}

describe.each(testCameras)('the rectangle of a sphere, $name', (camera) => {
  const { projection, near, far } = camera;
  const reach = Math.min(far, 60);
  const spheres = randomSpheres(120, createRandom(11), camera, reach, reach / 8);

  it('holds every point of it that is between near and far', () => {
    const random = createRandom(5);
    let points = 0;
    for (let i = 0; i < spheres.length; i += 4) {
      const [x, y, z, r] = spheres.subarray(i, i + 4);
      const visible = projectedSphereBounds([x, y, z, r], 0, projection, bounds);
      for (let k = 0; k < 100; k++) {
        const [dx, dy, dz] = randomDirection(random);
        const length = r * Math.cbrt(random());
        const depth = -(z + dz * length);
        if (depth < near || depth > far) continue;
        const [u, v] = project(projection, x + dx * length, y + dy * length, -depth);
        points++;
        if (visible) {
          const inside =
            u >= bounds[0] - 1e-9 && v >= bounds[1] - 1e-9 && u <= bounds[2] + 1e-9 && v <= bounds[3] + 1e-9;
          if (!inside) expect([u, v], `sphere ${[x, y, z, r].join()}`).toEqual([...bounds]);
        } else
          expect(
            Math.abs(u) > 1 || Math.abs(v) > 1,
            `a point on screen of the culled sphere ${[x, y, z, r].join()}`,
          ).toBe(true);
      }
    }
    expect(points).toBeGreaterThan(2000);
  });

  it('is no larger than it, to within a thousandth', () => {
    let compared = 0;
    for (let i = 0; i < spheres.length; i += 4) {
      const [x, y, z, r] = spheres.subarray(i, i + 4);
      const sampled = sampledBounds(x, y, z, r, projection, near, far);
      const onScreen = sampled[0] <= 1 && sampled[1] <= 1 && sampled[2] >= -1 && sampled[3] >= -1;
      const visible = projectedSphereBounds([x, y, z, r], 0, projection, bounds);
      if (onScreen) expect(visible, `sphere ${[x, y, z, r].join()}`).toBe(true);
      if (!visible) continue;
      compared++;
      for (let side = 0; side < 4; side++) {
        const size = Math.abs(sampled[(side + 2) % 4] - sampled[side]);
        const error = Math.abs(bounds[side] - sampled[side]);
        if (!(error <= 1e-3 * size + 1e-7 * Math.abs(sampled[side]))) {
          expect([...bounds], `side ${side}, sphere ${[x, y, z, r].join()}`).toEqual(sampled);
        }
      }
    }
    expect(compared).toBeGreaterThan(10);
  });
});

describe('projectedSphereBounds', () => {
  const m = perspective(-1, 1, -1, 1, 0.1, 100);

  it.each([
    ['behind the camera', [0, 0, 5, 4.8]],
    ['before the near plane', [0, 0, -0.02, 0.05]],
    ['beyond the far plane', [0, 0, -110, 9]],
    ['beside the frustum', [12, 0, -10, 1]],
    ['above the frustum', [0, -12, -10, 1]],
  ])('is false %s', (_, [x, y, z, r]) => {
    expect(projectedSphereBounds([x, y, z, r], 0, m, bounds)).toBe(false);
  });

  it('covers the screen when the camera is inside', () => {
    expect(projectedSphereBounds([0.5, 0, 1, 2], 0, m, bounds)).toBe(true);
    for (const side of bounds) expect(Math.abs(side)).toBeGreaterThan(1);
  });

  it('takes an infinite radius', () => {
    expect(projectedSphereBounds([0, 0, 0, Infinity], 0, m, bounds)).toBe(true);
    expect([...bounds]).toEqual([-Infinity, -Infinity, Infinity, Infinity]);
  });

  it('is never too small for an oblique near plane, as of a mirror', () => {
    // row 2 as set by three's Reflector: a tilted clip plane through (0, -1, -4)
    const oblique = [...m];
    [oblique[2], oblique[6], oblique[10], oblique[14]] = [0.3, 1.2, -0.5, 1.1];
    projectedSphereBounds([0.2, -0.5, -3, 1], 0, oblique, bounds);
    const found = [...bounds];
    projectedSphereBounds([0.2, -0.5, -3, 1], 0, m, bounds);
    for (const side of [0, 1]) expect(found[side]).toBeLessThanOrEqual(bounds[side] + 1e-9);
    for (const side of [2, 3]) expect(found[side]).toBeGreaterThanOrEqual(bounds[side] - 1e-9);
  });
});
