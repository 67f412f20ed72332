import { number, string, vector3 } from '@farol/editing/fields';
import { describe, expect, test } from 'vitest';
import { AssetLibrary } from '../assets/AssetLibrary';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { component } from './Component';
import { deserialize } from '../files/deserialize';
import { serialize } from '../files/serialize';
import { instantiatePrefab } from '../prefabs/instantiatePrefab';
import { makePrefab } from '../prefabs/makePrefab';
import { builtinComponents } from './builtinComponents';
import { ComponentRegistry } from './ComponentRegistry';
import { UnknownComponent } from './UnknownComponent';

const help = 'For a test.';

class Beacon extends component({
  rate: number(1, { help }),
  word: string('', { help }),
  aim: vector3([0, 0, 0], { help }),
}) {
  static override readonly typeName: string = 'Beacon';
  static override readonly version: number = 3;
}

const knowing = new ComponentRegistry([...builtinComponents.types.values(), Beacon]);
const keeping = (): ComponentRegistry => new ComponentRegistry(builtinComponents.types.values(), { keepUnknown: true });

function beaconScene(): Scene {
  const scene = new Scene({ name: 'Beacons', registry: knowing });
  const tower = new GameObject('Tower');
  tower.addComponent(Beacon, { rate: 4, word: 'castle', aim: [1, 2, 3] }, { enabled: false });
  scene.add(tower);
  return scene;
}

const textOf = (scene: Scene): string => JSON.stringify(serialize(scene));

describe('a component whose class is not known', () => {
  test('is refused by a registry that does not keep such', async () => {
    await expect(deserialize(textOf(beaconScene()))).rejects.toThrow(/names the unknown component 'Beacon'/);
    expect(() => keeping().create('Beacon')).toThrow(/Unknown component 'Beacon'/);
  });

  test('goes through a file as it is, copies included, and is itself again where its class is known', async () => {
    const text = textOf(beaconScene());
    const scene = await deserialize(text, { registry: keeping() });
    expect(textOf(scene)).toBe(text);
    const tower = scene.find('Tower')!;
    const kept = tower.getComponent('Beacon')!;
    expect(kept).toBeInstanceOf(UnknownComponent);
    expect(kept.authoredValues()).toEqual({ rate: 4, word: 'castle', aim: [1, 2, 3] });
    expect(kept.enabled).toBe(false);
    const copy = tower.clone();
    copy.name = 'Copy';
    scene.add(copy);
    const again = await deserialize(textOf(scene), { registry: knowing });
    for (const name of ['Tower', 'Copy']) {
      const beacon = again.find(name)!.getComponent(Beacon)!;
      expect(beacon.authoredValues()).toEqual({ rate: 4, word: 'castle', aim: [1, 2, 3] });
      expect(beacon.enabled).toBe(false);
    }
  });

  test('is kept in prefabs, and in what is made of them', async () => {
    const scene = beaconScene();
    const { prefab } = makePrefab(scene.find('Tower')!, 'Tower');
    scene.prefabs.set(prefab);
    const kept = await deserialize(textOf(scene), { registry: keeping() });
    expect(textOf(kept)).toBe(textOf(scene));
    const instance = instantiatePrefab(kept.prefabs.get(prefab.id)!, kept.registry);
    expect(instance.getComponent('Beacon')!.authoredValues()).toEqual({ rate: 4, word: 'castle', aim: [1, 2, 3] });
  });

  test('keeps an asset in the file that its data name', async () => {
    const assets = new AssetLibrary();
    assets.registerUrl('castle', 'castle.glb', 'model');
    assets.registerUrl('moat', 'moat.glb', 'model');
    const scene = await deserialize(textOf(beaconScene()), { registry: keeping(), assets });
    expect(serialize(scene).assets.map(({ name }) => name)).toEqual(['castle']);
  });

  test.each([
    ['a list', { rate: [1, 2] }, /values\.rate must be a number, text, true, false, null or \[x, y, z\]/],
    ['a member of every object', JSON.parse('{ "__proto__": 1 }') as object, /is not a name that a field can have/],
  ])('holds no %s', async (_, values, message) => {
    const file = serialize(beaconScene());
    file.objects[0].components[1].values = values as never;
    await expect(deserialize(file, { registry: keeping() })).rejects.toThrow(message);
  });

  test('comes back when its type is taken out of a registry', () => {
    const registry = new ComponentRegistry([Beacon], { keepUnknown: true });
    const data = { type: 'Beacon', version: 3, values: { rate: 2 } };
    expect(registry.createFrom(data)).toBeInstanceOf(Beacon);
    registry.unregister(Beacon);
    expect(registry.types.has('Beacon')).toBe(false);
    expect(registry.createFrom(data)).toBeInstanceOf(UnknownComponent);
    registry.register(Beacon);
    expect(registry.createFrom(data)).toBeInstanceOf(Beacon);
  });
});
