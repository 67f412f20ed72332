import { beforeEach, describe, expect, test } from 'vitest';
import { Light } from '../components/Light';
import { GameObject } from '../core/GameObject';
import { deserialize } from '../files/deserialize';
import { serialize } from '../files/serialize';
import { planApplyAll, planUnpack } from './applyOverrides';
import { makePrefab } from './makePrefab';
import { overridesOf } from './overrides';
import { changePrefab } from './planPrefabChange';
import type { Prefab } from '../core/Prefab';
import { lampPrefab, lightOf, newScene, place, registry, run, scene, take } from './testing/prefabScene';

beforeEach(() => newScene());

describe('a prefab within another', () => {
  /** A street that contains two lamps. */
  function street(): { lamp: GameObject; lampData: Prefab; street: GameObject; streetData: Prefab } {
    const { lamp, prefab } = lampPrefab();
    const road = new GameObject('Street');
    scene.add(road);
    place(prefab, road);
    lightOf(place(prefab, road)).intensity = 11;
    return { lamp, lampData: prefab, street: road, streetData: take(road) };
  }

  test('follows its own prefab, there and in every instance of the outer one', () => {
    const { lamp, street: first, streetData } = street();
    const second = place(streetData);
    lightOf(lamp).intensity = 6;
    run(planApplyAll(lamp));
    for (const each of [first, second]) {
      expect(each.children.map((child) => lightOf(child).intensity)).toEqual([6, 11]);
      expect(overridesOf(each)).toEqual({ fields: [], structural: [] });
    }
    expect(place(streetData).children.map((child) => lightOf(child).intensity)).toEqual([6, 11]);
  });

  test('keeps overrides of either level', () => {
    const { lamp, lampData, street: first, streetData } = street();
    const second = place(streetData);
    lightOf(second.children[0]).intensity = 20;
    const third = new GameObject('Third');
    third.addComponent(Light);
    lamp.add(third);
    lightOf(lamp).intensity = 6;
    run(planApplyAll(lamp));
    expect(second.children.map((child) => lightOf(child).intensity)).toEqual([20, 11]);
    expect(second.children.every((child) => child.find('Third'))).toBe(true);
    expect(first.children.every((child) => child.find('Third'))).toBe(true);
    // applied to the street's prefab, not the lamp's
    run(planApplyAll(second));
    expect(first.children.map((child) => lightOf(child).intensity)).toEqual([20, 11]);
    expect(lightOf(place(lampData)).intensity).toBe(6);
  });

  test('cannot hold itself', () => {
    const { lamp, streetData } = street();
    place(streetData, lamp);
    expect(() => planApplyAll(lamp)).toThrow(/'Lamp' would hold itself, by its object '\w+': take that one out/);
    expect(() => makePrefab(lamp.children[0])).toThrow(/part of 'Lamp'/);
  });

  test('unpacked outside is an instance of its own inside', () => {
    const { lamp, street: first } = street();
    run(planUnpack(first));
    lightOf(lamp).intensity = 6;
    run(planApplyAll(lamp));
    expect(first.children.map((child) => lightOf(child).intensity)).toEqual([6, 11]);
  });
});

describe('in a file', () => {
  test('prefabs, links and pins come back', async () => {
    const { lamp, prefab } = lampPrefab();
    lightOf(place(prefab)).intensity = 7;
    lightOf(lamp).intensity = 7;
    run(planApplyAll(lamp));
    const file = serialize(scene);
    expect(file.objects.flatMap((each) => each.prefab?.pinned ?? [])).toEqual(['Light.intensity']);
    const copy = await deserialize(JSON.stringify(file), { registry });
    expect(serialize(copy)).toEqual(file);
    const data = copy.prefabs.list[0];
    changePrefab(copy, { ...data, objects: data.objects.map((each) => ({ ...each, tags: ['new'] })) });
    expect(copy.roots.map(({ tags }) => tags)).toEqual([['new'], ['new']]);
  });

  test('what is wrong with them is named', async () => {
    const { prefab } = lampPrefab();
    const file = serialize(scene);
    const gone = { ...file, prefabs: [] };
    await expect(deserialize(gone, { registry })).rejects.toThrow(
      /objects\[0\]\.prefab\.prefab names the prefab "\w+", which is not in the file \(there: none\): remove "prefab"/,
    );
    const inside = prefab.objects.map((each, i) =>
      i === 1 ? { ...each, prefab: { prefab: prefab.id, source: 'x' } } : each,
    );
    await expect(deserialize({ ...file, prefabs: [{ ...prefab, objects: inside }] }, { registry })).rejects.toThrow(
      /prefabs\[0\] holds itself/,
    );
    await expect(deserialize({ ...file, prefabs: [{ ...prefab, id: 'other' }] }, { registry })).rejects.toThrow(
      /prefabs\[0\]\.objects must begin with one object/,
    );
    const unknown = prefab.objects.map((each) => ({
      ...each,
      components: [{ type: 'Laser', version: 1, id: 'l', values: {} }],
    }));
    await expect(deserialize({ ...file, prefabs: [{ ...prefab, objects: unknown }] }, { registry })).rejects.toThrow(
      /prefabs\[0\]\.objects\[0\]\.components\[0\]\.type names the unknown component 'Laser'/,
    );
  });
});
