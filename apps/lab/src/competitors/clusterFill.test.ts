import { createRandom } from '@farol/engine';
import { PerspectiveCamera, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { clusterFill, type Reach } from './clusterFill';

const camera = new PerspectiveCamera(60, 2, 0.5, 50);
camera.position.set(1, 2, 3);
camera.lookAt(0, 0, -10);
camera.updateMatrixWorld();
const grid = { width: 128, height: 64, tile: 32, slices: 6 };

/** A light in view space, at a distance in front of the camera. */
const before = (distance: number, radius: number, x = 0, y = 0): Reach => ({
  centre: new Vector3(x, y, -distance).applyMatrix4(camera.matrixWorld),
  radius,
});

describe('clusterFill', () => {
  it('counts each light in the clusters that it reaches', () => {
    expect(clusterFill([], camera, grid)).toEqual({ fullest: 0, dropped: 0 });
    const apart = [before(4, 0.1, -1, 0.5), before(4, 0.1, 1, 0.5), before(30, 0.1, 1, 0.5)];
    expect(clusterFill(apart, camera, grid).fullest).toBe(1);
    expect(clusterFill([...apart, ...apart], camera, grid).fullest).toBe(2);
    expect(clusterFill([...apart, before(1, Infinity)], camera, grid).fullest).toBe(2);
    expect(clusterFill([before(-20, 5), before(200, 5)], camera, grid).fullest).toBe(0);
  });

  it('goes by the distance to the bounds of a cluster', () => {
    // clusters meet at the middle of the picture
    const right = before(4, 0.05, 0.3, 0.3);
    const reaching = (radius: number, x: number, y: number) =>
      clusterFill([right, before(4, radius, x, y)], camera, grid).fullest;
    expect([reaching(0.22, -0.2, 0.3), reaching(0.18, -0.2, 0.3)]).toEqual([2, 1]);
    expect([reaching(0.22, 0.3, -0.2), reaching(0.18, 0.3, -0.2)]).toEqual([2, 1]);
    expect([reaching(0.3, -0.2, -0.2), reaching(0.25, -0.2, -0.2)]).toEqual([2, 1]);
  });

  it('never counts fewer than reach a point', () => {
    const random = createRandom(3);
    const lights = Array.from({ length: 200 }, () =>
      before(1 + 30 * random(), 0.5 + 3 * random(), 20 * random() - 10, 10 * random() - 5),
    );
    const { fullest } = clusterFill(lights, camera, grid);
    for (let i = 0; i < 500; i++) {
      const point = new Vector3(2 * random() - 1, 2 * random() - 1, random()).unproject(camera);
      const reaching = lights.filter(({ centre, radius }) => centre.distanceTo(point) < radius).length;
      expect(fullest).toBeGreaterThanOrEqual(reaching);
    }
  });

  it('tells lights that a limit leaves out, the nearest first', () => {
    const row = [3.6, 3.7, 3.8, 3.9].map((distance) => before(distance, 0.05, 0.1, 0.1));
    expect(clusterFill(row, camera, grid, 4)).toEqual({ fullest: 4, dropped: 0 });
    expect(clusterFill(row, camera, grid, 3)).toEqual({ fullest: 4, dropped: 1 });
  });
});
