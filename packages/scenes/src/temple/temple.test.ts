import { expect, test } from 'vitest';
import { AssetLibrary, Light } from '@farol/engine';
import { temple } from './temple';

const assets = new AssetLibrary();

const places = async (time: number, seed = 1): Promise<number[]> => {
  const scene = await temple(7, { seed, assets });
  scene.setTime(time);
  scene.three.updateMatrixWorld();
  const result = scene.componentsOf(Light).flatMap((light) => light.position.toArray());
  scene.dispose();
  return result;
};

test('the lights are at the same places at the same time in every run', async () => {
  const first = await places(3.7);
  expect(await places(3.7)).toEqual(first);
  expect(await places(3.8)).not.toEqual(first);
  expect(await places(3.7, 2)).not.toEqual(first);
});

test('has the lights that were asked for, a camera, and a temple of real columns', async () => {
  const scene = await temple(7);
  expect(scene.componentsOf(Light).filter((light) => light.type === 'point')).toHaveLength(7);
  expect(scene.activeCamera?.gameObject.name).toBe('Camera');
  const columns = scene.find('Columns')!.children;
  expect(columns).toHaveLength(26);
  scene.three.updateMatrixWorld();
  expect(scene.assets.materials.size).toBeLessThan(7);
  scene.dispose();
});
