import { beforeEach, describe, expect, test } from 'vitest';
import { Light } from '../components/Light';
import { ObjectRenderer } from '../components/ObjectRenderer';
import { RandomMovement } from '../components/RandomMovement';
import { GameObject } from '../core/GameObject';
import { serialize } from '../files/serialize';
import { planApplyAll, planApplyField, planRevertAll, planUnpack } from './applyOverrides';
import { fieldOverride, overridesOf } from './overrides';
import { planPrefabChange } from './planPrefabChange';
import { Follower, lampPrefab, lightOf, newScene, place, run, scene } from './testing/prefabScene';

beforeEach(() => newScene());

describe('an instance', () => {
  test('has what the prefab has, under ids of its own', () => {
    const { lamp, prefab } = lampPrefab();
    const other = place(prefab);
    expect(other.children.map(({ name }) => name)).toEqual(['Bulb']);
    expect(lightOf(other).intensity).toBe(5);
    expect(other.id).not.toBe(lamp.id);
    expect(lightOf(other).id).not.toBe(lightOf(lamp).id);
    expect(overridesOf(lamp)).toEqual({ fields: [], structural: [] });
    expect(overridesOf(other)).toEqual({ fields: [], structural: [] });
  });

  test('follows a field of the prefab, unless it has a value of its own', () => {
    const { lamp, prefab } = lampPrefab();
    const [follows, differs] = [place(prefab), place(prefab)];
    lightOf(differs).intensity = 9;
    expect(fieldOverride(lightOf(differs), 'intensity')).toMatchObject({ path: 'Bulb/Light.intensity', base: 5 });
    lightOf(lamp).intensity = 7;
    run(planApplyField(lightOf(lamp), 'intensity'));
    expect([lamp, follows, differs].map((each) => lightOf(each).intensity)).toEqual([7, 7, 9]);
    expect(overridesOf(lamp).fields).toEqual([]);
    expect(overridesOf(differs).fields.map(({ path }) => path)).toEqual(['Bulb/Light.intensity']);
  });

  test('keeps an override that the prefab happens to reach, until it is reverted', () => {
    const { lamp, prefab } = lampPrefab();
    const other = place(prefab);
    lightOf(other).intensity = 7;
    for (const [value, expected] of [
      [7, 7],
      [8, 7],
    ]) {
      lightOf(lamp).intensity = value;
      run(planApplyField(lightOf(lamp), 'intensity'));
      expect(lightOf(other).intensity).toBe(expected);
      expect(fieldOverride(lightOf(other), 'intensity')).not.toBeNull();
    }
    run(planRevertAll(other));
    expect(lightOf(other).intensity).toBe(8);
    expect(overridesOf(other).fields).toEqual([]);
    lightOf(lamp).intensity = 3;
    run(planApplyField(lightOf(lamp), 'intensity'));
    expect(lightOf(other).intensity).toBe(3);
  });

  test('has place, turn and name for itself', () => {
    const { lamp, prefab } = lampPrefab();
    const other = place(prefab);
    other.transform.position = [0, 0, 9];
    other.name = 'Mine';
    expect(overridesOf(other)).toEqual({ fields: [], structural: [] });
    lamp.transform.position = [4, 4, 4];
    lamp.name = 'Renamed';
    run(planApplyAll(lamp));
    expect(other.transform.position).toEqual([0, 0, 9]);
    expect(other.name).toBe('Mine');
    expect(place(prefab).transform.position).toEqual([1, 0, 0]);
    expect(place(prefab).name).toBe('Lamp');
  });

  test('that is applied whole gives the prefab objects and components, and takes away', () => {
    const { lamp, prefab } = lampPrefab();
    const other = place(prefab);
    const shade = new GameObject('Shade');
    shade.addComponent(ObjectRenderer, { mesh: 'cone' });
    lamp.add(shade);
    lamp.addComponent(RandomMovement, { speed: 3 });
    lamp.removeComponent(lamp.getComponent(ObjectRenderer)!);
    expect(overridesOf(lamp).structural.toSorted()).toEqual([
      'Lamp/ObjectRenderer removed',
      'Lamp/RandomMovement added',
      'Shade added',
    ]);
    run(planApplyAll(lamp));
    expect(overridesOf(lamp)).toEqual({ fields: [], structural: [] });
    expect(other.find('Shade')!.getComponent(ObjectRenderer)!.mesh).toBe('cone');
    expect(other.getComponent(RandomMovement)!.speed).toBe(3);
    expect(other.getComponent(ObjectRenderer)).toBeNull();
    lamp.remove(shade);
    run(planApplyAll(lamp));
    expect(other.find('Shade')).toBeNull();
  });

  test('keeps what was added to it, and what was taken out stays out', () => {
    const { lamp, prefab } = lampPrefab();
    const other = place(prefab);
    other.remove(other.children[0]);
    other.add(new GameObject('Own'));
    other.addComponent(RandomMovement);
    lightOf(lamp).intensity = 2;
    run(planApplyAll(lamp));
    expect(other.children.map(({ name }) => name)).toEqual(['Own']);
    expect(other.getComponent(RandomMovement)).not.toBeNull();
    run(planRevertAll(other));
    expect(other.children.map(({ name }) => name)).toEqual(['Bulb']);
    expect(lightOf(other).intensity).toBe(2);
    expect(other.getComponent(RandomMovement)).toBeNull();
  });

  test('has references within itself', () => {
    const { lamp } = lampPrefab();
    lamp.addComponent(Follower, { target: lamp.children[0].id });
    run(planApplyAll(lamp));
    const other = place(scene.prefabs.list[0]);
    expect(other.getComponent(Follower)!.target).toBe(other.children[0].id);
    expect(overridesOf(other).fields).toEqual([]);
    expect(overridesOf(lamp).fields).toEqual([]);
  });

  test('copied is an instance; a part of it copied is none', () => {
    const { lamp } = lampPrefab();
    const copy = lamp.clone();
    scene.add(copy);
    const part = lamp.children[0].clone();
    scene.add(part);
    lightOf(lamp).intensity = 1;
    run(planApplyAll(lamp));
    expect(lightOf(copy).intensity).toBe(1);
    expect(part.getComponent(Light)!.intensity).toBe(5);
    expect(part.prefabLink).toBeNull();
  });

  test('unpacked follows no more', () => {
    const { lamp, prefab } = lampPrefab();
    const other = place(prefab);
    run(planUnpack(other));
    expect(other.prefabLink).toBeNull();
    lightOf(lamp).intensity = 1;
    run(planApplyAll(lamp));
    expect(lightOf(other).intensity).toBe(5);
  });
});

test('nothing is changed by a plan', () => {
  const { lamp, prefab } = lampPrefab();
  place(prefab);
  const before = JSON.stringify(serialize(scene));
  lightOf(lamp).intensity = 2;
  planPrefabChange(scene, { ...prefab, objects: prefab.objects.map((each) => ({ ...each, active: false })) });
  planApplyAll(lamp);
  lightOf(lamp).intensity = 5;
  expect(JSON.stringify(serialize(scene))).toBe(before);
});

test('what goes with an object that is removed is not removed once more', () => {
  const { lamp, prefab } = lampPrefab();
  const [bulb] = lamp.children;
  place(prefab, bulb);
  const objects = prefab.objects.filter(({ name }) => name !== 'Bulb');
  const plan = planPrefabChange(scene, { ...prefab, objects });
  expect(plan.edits.flatMap((edit) => (edit.kind === 'remove-object' ? [edit.object] : []))).toEqual([bulb]);
  run(plan);
  expect(lamp.children).toEqual([]);
});
