import { AssetLibrary, Scene } from '@farol/engine';
import { expect, test } from 'vitest';
import { assetEntries, builtinName } from './assetKinds';

test('a prefab and an asset of one name are two cards, prefabs first and what came with Farol last', () => {
  const scene = new Scene({ assets: new AssetLibrary() });
  scene.assets.addMaterial('Gold');
  scene.prefabs.set({
    id: 'brick',
    name: 'Walls/Brick',
    objects: [{ id: 'brick', name: 'Brick', parent: null, components: [] }],
  });
  const entries = assetEntries(scene);
  expect(entries[0]).toMatchObject({ kind: 'prefab', name: 'brick', folder: 'Walls', label: 'Brick' });
  expect(entries[1]).toMatchObject({ kind: 'material', name: 'Gold', isBuiltin: false });
  expect(entries.slice(2).every(({ isBuiltin }) => isBuiltin)).toBe(true);
  expect(entries.filter(({ name }) => name === 'brick').map(({ kind }) => kind)).toEqual(['prefab', 'texture']);
  expect(new Set(entries.map(({ kind, name }) => `${kind}/${name}`)).size).toBe(entries.length);
});

test('what comes with Farol has names of words, and keeps the name that files use', () => {
  expect(['box', 'cloth-red', 'marble-normal@512', 'profile/street-light'].map(builtinName)).toEqual([
    'Box',
    'Cloth red',
    'Marble, normal map, 512',
    'Street light',
  ]);
  const entries = assetEntries(new Scene({ assets: new AssetLibrary() }));
  expect(entries.find(({ name }) => name === 'wood-normal')).toMatchObject({ label: 'Wood, normal map', model: null });
});
