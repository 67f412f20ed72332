import { builtinComponents, ComponentRegistry, Light, Scene } from '@farol/engine';
import { parseFile, serialize, UnknownComponent } from '@farol/engine/files';
import { instantiatePrefab, overridesOf } from '@farol/engine/prefabs';
import { expect, it } from 'vitest';
import { buildLibraryItem } from './buildLibraryItem';
import { libraryNames } from './names';

const { sky: _, ...groups } = libraryNames;
const ids = Object.values(groups).flatMap((names) => Object.keys(names));

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
    const registry = new ComponentRegistry(builtinComponents.types.values(), { keepUnknown: true });
    const scene = new Scene({ registry });
    for (const { name, type, values } of assets) scene.assets.addFieldAsset(type as 'material', name, values!);
    scene.prefabs.set(prefab);
    const instance = instantiatePrefab(prefab, scene.registry);
    scene.add(instance);
    const { fields, structural } = overridesOf(instance);
    // scripts do not run here: references in their components, kept as data, are not checked
    const paths = fields.filter(({ component }) => !(component instanceof UnknownComponent)).map(({ path }) => path);
    expect([paths, structural], id).toEqual([[], []]);
    const file = serialize(scene);
    const read = parseFile(JSON.parse(JSON.stringify(file)), { registry: scene.registry, assets: scene.assets });
    expect(read.prefabs?.[0].objects, id).toEqual(prefab.objects);
    // values of an asset are compared without defaults when another copy is added
    for (const { name, values } of assets) expect(scene.assets.fieldAsset(name)!.changedValues(), name).toEqual(values);
    for (const light of scene.componentsOf(Light)) expect(light.intensity, id).toBeGreaterThan(0);
    scene.dispose();
  }
});
