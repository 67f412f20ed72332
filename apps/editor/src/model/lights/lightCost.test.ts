import { GameObject, Light, Scene } from '@farol/engine';
import { OrthographicCamera, PerspectiveCamera } from 'three';
import { expect, test } from 'vitest';
import { CostEstimate, type CostView } from './lightCost';

const camera = new PerspectiveCamera(60, 16 / 9, 0.1, 100);
camera.updateMatrixWorld();
const view = { camera, width: 1280, height: 720 };

const lightCosts = (lights: readonly Light[], seen: CostView): Float64Array => new CostEstimate(lights, seen).next()!;

function lamp(scene: Scene, z: number, values: Parameters<GameObject['addComponent']>[1] = {}): Light {
  const object = new GameObject('Lamp');
  scene.add(object);
  object.transform.position = [0, 0, z];
  object.object3D.updateWorldMatrix(true, true);
  return object.addComponent(Light, values);
}

test('shares add up to one, and go by tiles, kind and shadow; what is off or behind costs nothing', () => {
  const scene = new Scene();
  const lights = [
    lamp(scene, -20, { range: 2 }),
    lamp(scene, -20, { range: 2, castShadow: true }),
    lamp(scene, -20, { type: 'directional' }),
    lamp(scene, 20, { range: 2 }),
    lamp(scene, -20, { type: 'ambient' }),
    lamp(scene, 0, { range: 5 }),
  ];
  lights[5].enabled = false;
  const [point, shadowed, sun, behind, ambient, off] = lightCosts(lights, view);
  expect([behind, ambient, off]).toEqual([0, 0, 0]);
  expect(point + shadowed + sun).toBeCloseTo(1, 12);
  expect(shadowed).toBeCloseTo(2 * point, 12);
  expect(sun / point).toBeGreaterThan(40);
  lights[5].enabled = true;
  expect(lightCosts(lights, view)[5]).toBeCloseTo(lightCosts(lights, view)[2], 12);
});

test('a spot covers less than a point light of its range, and an orthographic view does not care for distance', () => {
  const scene = new Scene();
  const [point, spot] = lightCosts(
    [lamp(scene, -20, { range: 4 }), lamp(scene, -20, { type: 'spot', range: 4, cutoff: 0.4 })],
    view,
  );
  expect(spot).toBeLessThan(0.6 * point);
  const flat = new OrthographicCamera(-10, 10, 10, -10, 0.1, 100);
  flat.updateMatrixWorld();
  const [near, far] = lightCosts([lamp(scene, -10, { range: 2 }), lamp(scene, -60, { range: 2 })], {
    ...view,
    camera: flat,
  });
  expect(near).toBeCloseTo(far, 12);
});

test('10,000 lights take ten tasks of a thousand each', () => {
  const scene = new Scene();
  const light = lamp(scene, -20);
  const estimate = new CostEstimate(
    Array.from({ length: 10_000 }, () => light),
    view,
  );
  for (let i = 0; i < 9; i++) expect(estimate.next()).toBeNull();
  expect(estimate.next()![9999]).toBeCloseTo(1e-4, 12);
});
