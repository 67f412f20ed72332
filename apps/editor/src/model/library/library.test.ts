import { Light, Scene } from '@farol/engine';
import { parseFile, serialize } from '@farol/engine/files';
import { instantiatePrefab } from '@farol/engine/prefabs';
import { expect, it } from 'vitest';
import { buildLibraryItem } from './buildLibraryItem';
import { libraryNames } from './names';

const ids = Object.values(libraryNames).flatMap((names) => Object.keys(names));

it('has every lamp that the issue names, each with at least one light, and props', () => {
  expect(ids.length).toBe(new Set(ids).size);
  for (const id of Object.keys(libraryNames.lamp)) {
    const lights = buildLibraryItem(id)!.prefab.objects.flatMap(({ components }) =>
      components.filter(({ type }) => type === 'Light'),
    );
    expect(lights.length, id).toBeGreaterThan(0);
  }
  expect(Object.keys(libraryNames.lamp).length).toBeGreaterThanOrEqual(14);
});

it('builds prefabs that a file can have: known components, allowed values, and the materials that they name', () => {
  for (const id of ids) {
    const { prefab, assets } = buildLibraryItem(id)!;
    const scene = new Scene();
    for (const { name, values } of assets) scene.assets.addFieldAsset('material', name, values);
    scene.prefabs.set(prefab);
    scene.add(instantiatePrefab(prefab, scene.registry));
    const file = serialize(scene);
    const read = parseFile(JSON.parse(JSON.stringify(file)), { registry: scene.registry, assets: scene.assets });
    expect(read.prefabs?.[0].objects, id).toEqual(prefab.objects);
    // what an asset holds besides its defaults is compared when another copy comes
    for (const { name, values } of assets) expect(scene.assets.fieldAsset(name)!.changedValues(), name).toEqual(values);
    for (const light of scene.componentsOf(Light)) expect(light.intensity, id).toBeGreaterThan(0);
    scene.dispose();
  }
});
