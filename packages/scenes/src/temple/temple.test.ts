import { expect, test } from 'vitest';
import { AssetLibrary, Light, ObjectRenderer, type Scene } from '@farol/engine';
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

test('in the evening the sun alone casts shadows, under tone mapping; else the light is even', async () => {
  const casts = (scene: Scene): string[] =>
    scene.componentsOf(Light).flatMap((light) => (light.castShadow ? [light.type] : []));
  const evening = await temple(7, { assets, evening: true });
  expect(casts(evening)).toEqual(['directional']);
  expect(evening.settings.toneMapping).not.toBe('none');
  expect(evening.find('Roof')!.getComponent(ObjectRenderer)!.castShadow).toBe(true);
  evening.dispose();
  const even = await temple(7, { assets });
  expect(casts(even)).toEqual([]);
  expect(even.settings.toneMapping).toBe('none');
  even.dispose();
});
