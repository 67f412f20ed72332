import { Camera, PerspectiveCamera, PointLight, Scene } from 'three';
import { expect, it } from 'vitest';
import { FoundLights } from '../lights/FoundLights';
import { collectLights } from '../renderer/collectLights';
import { readLightsInRows } from '../techniques/light-lists/readLights';
import { rankByDepth } from '../techniques/light-lists/rankByDepth';
import { type PlainPoints, POINT } from '../lights/plainPoints';
import { LightTable } from './LightTable';

/** Maximum number of a plain point light's properties that a frame may read; each read of colour or matrix counts as one. */
const MOST_READS = 8;
/** Number of properties read to find a light and update its matrices. */
const FOUND_READS = 22;

readLightsInRows();

let reads = 0;

function countedLight(): PointLight {
  const light = new PointLight(0xffffff, 1, 5);
  light.position.z = -10;
  light.updateMatrixWorld();
  return new Proxy(light, {
    get: (target, key) => {
      reads++;
      return Reflect.get(target, key, target) as unknown;
    },
  });
}

function makeCamera(): PerspectiveCamera {
  const camera = new PerspectiveCamera(60, 1, 0.1, 100);
  camera.updateMatrixWorld();
  return camera;
}

it.each([
  [50, MOST_READS],
  [64, MOST_READS],
])(
  'reads few properties of each of %i plain point lights a frame, moved or not: each may wait for memory',
  (n, most) => {
    const camera = makeCamera();
    const lights = Array.from({ length: n }, countedLight);
    const table = new LightTable();
    const readsOfFrame = (points: PlainPoints | null = null): number => {
      reads = 0;
      table.collect(lights, camera, { shadows: 'all', layers: null }, points);
      table.write(camera, 'by-depth', { width: 64, height: 64 }, null, rankByDepth);
      return reads / n;
    };
    expect(readsOfFrame()).toBe(most);
    expect(readsOfFrame()).toBe(most);
    for (const { matrixWorld } of lights) matrixWorld.elements[12] = 1;
    expect(readsOfFrame()).toBe(most);
    expect(table.visible).toBe(n);
    const points = Float64Array.from({ length: n * POINT }, (_, i) => [-10, -10, -10, 5, 1, 2, 3, 0][i % POINT]);
    expect(readsOfFrame(points), 'what was read as lights were found is not read again').toBe(0);
    expect(Array.from(table.spheres.subarray(0, 4))).toEqual([-10, -10, -10, 5]);
    expect(Array.from(table.emissions.subarray(0, 4))).toEqual([1, 2, 3, 0]);
  },
);

it('reads few properties of a light to find it and to bring its matrices up to date', () => {
  const scene = new Scene();
  for (let i = 0; i < 50; i++) {
    const light = countedLight();
    light.parent = scene;
    scene.children.push(light);
  }
  const found = new FoundLights();
  const left = { shadows: false, cookies: false, areas: false, all: false };
  for (let frame = 0; frame < 3; frame++) {
    reads = 0;
    collectLights(scene, new Camera(), left, found, true);
    // the first light has one more read; not in the first frame, which computes all matrices
    if (frame > 0) expect((reads - 1) / 50).toBe(FOUND_READS);
  }
  expect(found.count).toBe(50);
});
