import { expect, it } from 'vitest';
import { LightGrid } from './LightGrid';
import { createRandom, perspective, randomCones, randomSpheres, testCameras } from './testing/testScenes';

const COUNT = 60;

function makeInputs() {
  const random = createRandom(5);
  return {
    count: COUNT,
    spheres: randomSpheres(COUNT, random, testCameras[0], 30, 4),
    projection: perspective(-1, 1, -1, 1, 0.1, 100),
    near: 0.1,
    far: 100,
    width: 320,
    height: 184,
    cones: randomCones(COUNT, random) as Float32Array | null,
  };
}
type Inputs = ReturnType<typeof makeInputs>;

function update(grid: LightGrid, inputs: Inputs): LightGrid {
  const { count, spheres, projection, near, far, width, height, cones } = inputs;
  grid.update(count, spheres, projection, near, far, width, height, cones);
  return grid;
}

const changes: readonly (readonly [string, (inputs: Inputs) => void])[] = [
  ['a light less', (inputs) => inputs.count--],
  ['that light again', (inputs) => inputs.count++],
  ['the first sphere', ({ spheres }) => (spheres[0] += 0.5)],
  ['the radius of the last sphere', ({ spheres }) => (spheres[COUNT * 4 - 1] += 0.5)],
  ['the axis of a cone', ({ cones }) => (cones![4] *= -1)],
  ['the cutoff of the last cone', ({ cones }) => (cones![COUNT * 4 - 1] = 0.5)],
  ['no cones', (inputs) => (inputs.cones = null)],
  ['a number of the projection', ({ projection }) => ((projection as number[])[8] += 0.25)],
  ['the near plane', (inputs) => (inputs.near = 0.2)],
  ['the far plane', (inputs) => (inputs.far = 90)],
  ['the width', (inputs) => (inputs.width = 256)],
  ['the height', (inputs) => (inputs.height = 128)],
  ['all spheres', (inputs) => (inputs.spheres = randomSpheres(COUNT, createRandom(9), testCameras[0], 30, 4))],
];

it('makes the masks anew for each input that differs, and only then', () => {
  const inputs = makeInputs();
  const grid = update(new LightGrid(), inputs);
  update(grid, inputs);
  expect(grid.changes).toBe(1);
  let expected = 1;
  for (const [name, change] of changes) {
    change(inputs);
    update(grid, inputs);
    expect(grid.changes, name).toBe(++expected);
    update(grid, inputs);
    expect(grid.changes, name).toBe(expected);
    const fresh = update(new LightGrid(), inputs);
    const words = fresh.tilesX * fresh.tilesY * fresh.words;
    expect(grid.count, name).toBe(fresh.count);
    expect(grid.order.subarray(0, grid.count), name).toEqual(fresh.order.subarray(0, fresh.count));
    expect(grid.masks.subarray(0, words), name).toEqual(fresh.masks.subarray(0, words));
    expect(grid.bins, name).toEqual(fresh.bins);
  }
});
