import { BoxGeometry } from 'three';
import { expect, test } from 'vitest';
import { AssetLibrary } from '@farol/engine';
import { deserialize, serialize } from '@farol/engine/files';
import { scenes } from './index';
import { registerSceneAssets } from './registerSceneAssets';

const ofScenes = (assets: AssetLibrary): string[] => assets.list('mesh').filter((name) => name.includes('/'));

test('a library knows the meshes of a scene once that scene was built with it', async () => {
  const assets = new AssetLibrary();
  expect(ofScenes(assets)).toEqual([]);
  const scene = await scenes.temple.build({ lights: 0 }, assets);
  expect(ofScenes(assets)).toContain('temple/column');
  expect(ofScenes(assets).filter((name) => !name.startsWith('temple/'))).toEqual([]);
  scene.dispose();
});

test('all of them can be offered at once; a name that is taken keeps its asset', () => {
  const assets = new AssetLibrary();
  const own = new BoxGeometry();
  assets.register('temple/column', own);
  registerSceneAssets(assets);
  registerSceneAssets(assets);
  expect(ofScenes(assets)).toEqual(expect.arrayContaining(['temple/steps', 'sponza/vault']));
  expect(assets.get('temple/column')).toBe(own);
  expect(assets.isBuiltin('temple/column')).toBe(false);
  expect(assets.isBuiltin('temple/steps')).toBe(true);
});

test('a file that names them opens in a library that has none, and an unknown name is told', async () => {
  const scene = await scenes.temple.build({ lights: 0 });
  const file = serialize(scene);
  const copy = await deserialize(file);
  expect(serialize(copy)).toEqual(file);
  const text = JSON.stringify(file).replaceAll('temple/column', 'temple/obelisk');
  await expect(deserialize(text)).rejects.toThrow(/the mesh 'temple\/obelisk', which is unknown/);
  scene.dispose();
  copy.dispose();
});

test.each(['dragons', 'niceScene'])('%s needs nothing but the library', async (name) => {
  const scene = await scenes[name].build({ lights: 1 });
  expect(scene.find('Dragon')!.getComponent('ObjectRenderer')).toBeTruthy();
  scene.dispose();
});
