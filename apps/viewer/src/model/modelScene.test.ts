import { AssetLibrary, type Camera, Light, RandomMovement } from '@farol/engine';
import { AnimationClip, BoxGeometry, Group, Mesh, PerspectiveCamera, Vector3 } from 'three';
import { expect, it } from 'vitest';
import type { LoadedModel } from './loadModel';
import { modelScene } from './modelScene';

/** A scene of a box of 1 × 2 × 1 m times `size`, away from the origin. */
function sceneOf(size: number, lights = 8) {
  const box = new Mesh(new BoxGeometry(size, 2 * size, size));
  box.position.set(3 * size, size, 0);
  const gltf = { scene: new Group().add(box), animations: [] as AnimationClip[] };
  const model = { name: 'box.glb', gltf, notes: [] } as unknown as LoadedModel;
  const scene = modelScene(model, { lights, seed: 1 }, new AssetLibrary());
  scene.three.updateMatrixWorld(true);
  return { scene, points: scene.componentsOf(Light).filter(({ type }) => type === 'point'), box };
}

it('looks the same whatever the size of the model is: places, reach and brightness of its lights grow with it', () => {
  const [one, ten] = [sceneOf(1), sceneOf(10)];
  expect(one.points).toHaveLength(8);
  one.points.forEach((light, i) => {
    const large = ten.points[i];
    // illuminance falls with the square of the distance
    expect(large.intensity / light.intensity).toBeCloseTo(100, 6);
    expect(large.range / light.range).toBeCloseTo(10, 6);
    for (const axis of ['x', 'y', 'z'] as const) expect(large.position[axis]).toBeCloseTo(10 * light.position[axis], 4);
    const [path, wide] = [light, large].map(({ gameObject }) => gameObject.getComponent(RandomMovement)!);
    expect(wide.speed / path.speed).toBeCloseTo(10, 6);
    path.extent.forEach((way, axis) => expect(wide.extent[axis] / way).toBeCloseTo(10, 6));
  });
});

it('is nearly as bright by many lights as by few', () => {
  const light = (count: number): number => {
    const { points } = sceneOf(1, count);
    return points.reduce((sum, { intensity }) => sum + intensity, 0);
  };
  expect(light(400) / light(4)).toBeGreaterThan(1);
  expect(light(400) / light(4)).toBeLessThan(2);
});

it.each([0.01, 1, 500])('the camera sees all of a model of %d m, from above its ground', (size) => {
  const { scene, box } = sceneOf(size);
  const { three } = scene.activeCamera as Camera;
  expect(three).toBeInstanceOf(PerspectiveCamera);
  three.updateMatrixWorld(true);
  expect(new Vector3().setFromMatrixPosition(three.matrixWorld).y).toBeGreaterThan(0);
  for (const corner of [0, 1, 2, 3, 4, 5, 6, 7]) {
    const sign = (bit: number): number => (corner & bit ? 0.5 : -0.5);
    const at = new Vector3(sign(1), 2 * sign(2), sign(4)).multiplyScalar(size).add(box.position).project(three);
    for (const value of at.toArray()) expect(Math.abs(value)).toBeLessThan(1);
  }
});

it('is refused with its name when there is nothing to see', () => {
  const model = { name: 'empty.glb', gltf: { scene: new Group(), animations: [] } } as unknown as LoadedModel;
  expect(() => modelScene(model, { lights: 1, seed: 1 }, new AssetLibrary())).toThrow(
    /^empty\.glb: its scene has no mesh/,
  );
});
