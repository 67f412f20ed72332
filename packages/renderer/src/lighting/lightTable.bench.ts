import { PerspectiveCamera, PointLight, SpotLight, type Light } from 'three';
import { bench, describe } from 'vitest';
import { LightTable } from './LightTable';
import { rankByDepth } from '../techniques/light-lists/rankByDepth';
import { rankByGrid } from '../techniques/light-lists/rankByGrid';
import { createRandom } from '../lights/testing/testScenes';

/**
 * Time to write the records of one frame in which every light has moved, without the upload.
 * `npx vitest bench --run --config packages/vitest.config.ts lightTable`
 */
const camera = new PerspectiveCamera(60, 16 / 9, 0.1, 100);
camera.updateMatrixWorld();
const size = { width: 1280, height: 720 };
const orders = [
  ['by-volume', null],
  ['by-depth', rankByDepth],
  ['by-grid', rankByGrid],
] as const;

/** Lights all over a hall of 20 × 16 × 40 m; every `spots`-th is a spot light. */
function hall(count: number, spots: number): Light[] {
  const random = createRandom(7);
  return Array.from({ length: count }, (_, i) => {
    const light = i % spots === spots - 1 ? new SpotLight(0xffffff, 1, 1) : new PointLight(0xffffff, 1, 1);
    light.position.set((random() - 0.5) * 20, (random() - 0.3) * 16, 2 - random() * 40);
    light.updateMatrixWorld();
    return light;
  });
}

describe.each([
  ['10,000 point lights', hall(10_000, Infinity)],
  ['10,000 lights, a third of them spot lights', hall(10_000, 3)],
])('%s', (_, lights) => {
  for (const [order, rank] of orders) {
    const table = new LightTable();
    let shift = 0;
    bench(
      order,
      () => {
        shift = shift > 0 ? -0.01 : 0.01;
        for (const { matrixWorld } of lights) matrixWorld.elements[12] += shift;
        table.collect(lights, camera, { shadows: 'none', layers: null });
        table.write(camera, order, size, null, rank);
      },
      { time: 1500, warmupTime: 500 },
    );
  }
});
