import { bench, describe } from 'vitest';
import { LightGrid } from './LightGrid';
import { createRandom, perspective } from './testing/testScenes';

/** Time of one update at 1280 × 720. `npx vitest bench --run --config packages/vitest.config.ts lightGrid` */
const near = 0.1;
const far = 100;
const projection = perspective(-1.0264, 1.0264, -0.57735, 0.57735, near, far);

/** Lights all over a hall of 20 × 16 × 40 m, seen from two metres inside its end. */
function hall(count: number, radius: number): Float32Array {
  const random = createRandom(7);
  const spheres = new Float32Array(count * 4);
  for (let i = 0; i < count; i++) {
    spheres.set([(random() - 0.5) * 20, (random() - 0.3) * 16, 2 - random() * 40, radius], i * 4);
  }
  return spheres;
}

/** Lights spread evenly over the view's depth, so that many are near. */
function view(count: number, radius: number): Float32Array {
  const random = createRandom(12);
  const spheres = new Float32Array(count * 4);
  for (let i = 0; i < count; i++) {
    const depth = 1 + random() * 59;
    spheres.set([(random() * 2 - 1) * depth * 1.03, (random() * 2 - 1) * depth * 0.577, -depth, radius], i * 4);
  }
  return spheres;
}

describe.each([
  ['100 lights of 5 m in a hall of 40 m', hall(100, 5)],
  ['1,000 lights of 5 m in a hall of 40 m', hall(1000, 5)],
  ['2,000 lights of 5 m in a hall of 40 m', hall(2000, 5)],
  ['10,000 lights of 1 m in a hall of 40 m', hall(10_000, 1)],
  ['10,000 lights of 1 m evenly over a view of 60 m', view(10_000, 1)],
])('%s', (_, spheres) => {
  for (const tileSize of [16, 32]) {
    const grid = new LightGrid(tileSize);
    // a grid is kept while its inputs are equal
    let frame = 0;
    bench(
      `tiles of ${tileSize} pixels`,
      () => grid.update(spheres.length / 4, spheres, projection, near, far + (frame++ % 2), 1280, 720),
      {
        time: 1000,
        warmupTime: 300,
      },
    );
  }
});
