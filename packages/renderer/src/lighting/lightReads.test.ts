import { PerspectiveCamera, PointLight } from 'three';
import { expect, it } from 'vitest';
import { rankByDepth } from '../techniques/light-lists/rankByDepth';
import { LightTable } from './LightTable';

/** Properties that a frame may read of a plain point light, its colour and matrix counted as one each time. */
const MOST_READS = 21;

it('reads few properties of a plain point light a frame, whether it moved or not: each may wait for memory', () => {
  const camera = new PerspectiveCamera(60, 1, 0.1, 100);
  camera.updateMatrixWorld();
  let reads = 0;
  const lights = Array.from({ length: 50 }, () => {
    const light = new PointLight(0xffffff, 1, 5);
    light.position.z = -10;
    light.updateMatrixWorld();
    return new Proxy(light, {
      get: (target, key) => {
        reads++;
        return Reflect.get(target, key, target) as unknown;
      },
    });
  });
  const table = new LightTable();
  const readsOfFrame = (): number => {
    reads = 0;
    table.collect(lights, camera, { shadows: 'all', layers: null });
    table.write(camera, 'by-depth', { width: 64, height: 64 }, null, rankByDepth);
    return reads / lights.length;
  };
  expect(readsOfFrame()).toBe(MOST_READS);
  expect(readsOfFrame()).toBe(MOST_READS);
  for (const { matrixWorld } of lights) matrixWorld.elements[12] = 1;
  expect(readsOfFrame()).toBe(MOST_READS);
  expect(table.visible).toBe(50);
});
