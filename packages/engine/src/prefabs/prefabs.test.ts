import { boolean, number, object, string } from '@farol/editing/fields';
import { BoxGeometry, Mesh } from 'three';
import { beforeEach, describe, expect, test } from 'vitest';
import { Model } from '../assets/Model';
import { loadSurfaceCode } from '../assets/surfaceCode';
import { Light } from '../components/Light';
import { ModelRenderer } from '../components/ModelRenderer';
import { ObjectRenderer } from '../components/ObjectRenderer';
import { RandomMovement } from '../components/RandomMovement';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { component } from '../core/Component';
import { ComponentRegistry } from '../core/ComponentRegistry';
import { builtinComponents } from '../components/index';
import { deserialize } from '../files/deserialize';
import { serialize } from '../files/serialize';
import { planApplyAll, planApplyField, planRevertAll, planUnpack } from './applyOverrides';
import { instantiatePrefab } from './instantiatePrefab';
import { makePrefab } from './makePrefab';
import { fieldOverride, overridesOf } from './overrides';
import { changePrefab, planPrefabChange, type PrefabPlan } from './planPrefabChange';
import type { Prefab } from '../core/Prefab';
import { applyPrefabEdit, type PrefabEdit } from './PrefabEdit';

class Follower extends component({ target: object(null, { help: 'What it follows.' }) }) {
  static override readonly typeName: string = 'Follower';
}

const registry = new ComponentRegistry([...builtinComponents.types.values(), Follower]);
let scene: Scene;

beforeEach(() => {
  scene = new Scene({ registry });
});

const run = (plan: PrefabPlan | readonly PrefabEdit[]): void => {
  if ('prefabs' in plan) for (const prefab of plan.prefabs) scene.prefabs.set(prefab);
  ('prefabs' in plan ? plan.edits : plan).forEach(applyPrefabEdit);
};

/** Lamp > Bulb (a light); the prefab of it, whose first instance is the lamp itself. */
function lampPrefab(): { lamp: GameObject; prefab: Prefab } {
  const lamp = new GameObject('Lamp');
  lamp.transform.position = [1, 0, 0];
  lamp.addComponent(ObjectRenderer, { mesh: 'cylinder' });
  const bulb = new GameObject('Bulb');
  bulb.addComponent(Light, { intensity: 5 });
  lamp.add(bulb);
  scene.add(lamp);
  return { lamp, prefab: take(lamp) };
}

/** Makes a prefab of an object, which becomes its first instance. */
function take(from: GameObject): Prefab {
  const made = makePrefab(from);
  scene.prefabs.set(made.prefab);
  for (const [each, link] of made.links) each.prefabLink = link;
  return made.prefab;
}

function place(prefab: Prefab, parent: GameObject | Scene = scene): GameObject {
  const instance = instantiatePrefab(scene.prefabs.get(prefab.id)!, registry);
  parent.add(instance);
  return instance;
}

const lightOf = (root: GameObject): Light => root.find('Bulb')!.getComponent(Light)!;

describe('an instance', () => {
  test('has what the prefab has, under ids of its own', () => {
    const { lamp, prefab } = lampPrefab();
    const other = place(prefab);
    expect(other.children.map(({ name }) => name)).toEqual(['Bulb']);
    expect(lightOf(other).intensity).toBe(5);
    expect(other.id).not.toBe(lamp.id);
    expect(lightOf(other).id).not.toBe(lightOf(lamp).id);
    expect(overridesOf(lamp)).toEqual({ fields: [], others: [] });
    expect(overridesOf(other)).toEqual({ fields: [], others: [] });
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
    expect(overridesOf(other)).toEqual({ fields: [], others: [] });
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
    expect(overridesOf(lamp).others.toSorted()).toEqual([
      'Lamp/ObjectRenderer removed',
      'Lamp/RandomMovement added',
      'Shade added',
    ]);
    run(planApplyAll(lamp));
    expect(overridesOf(lamp)).toEqual({ fields: [], others: [] });
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

describe('a prefab within another', () => {
  /** Street > two lamps. */
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
      expect(overridesOf(each)).toEqual({ fields: [], others: [] });
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
    // applied to the street, not to the lamp
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

describe('the values of a surface that an object wears by itself', () => {
  const text = (more = ''): string =>
    `uniform float a; // = 1\nuniform float b; // = 2\n${more}void surface(inout SurfaceData s) {}`;
  const values = (root: GameObject): unknown[] => {
    const renderer = root.getComponent(ObjectRenderer)!;
    return [renderer.get('surface.a'), renderer.get('surface.b')];
  };

  test('are overridden one by one', async () => {
    await loadSurfaceCode();
    scene.assets.addFieldAsset('surface', 'Rust', { source: text() });
    const first = new GameObject('Crate');
    scene.add(first);
    const renderer = first.addComponent(ObjectRenderer, { surface: 'Rust' });
    renderer.set('surface.a', 5);
    const prefab = take(first);
    const other = place(prefab);
    const own = other.getComponent(ObjectRenderer)!;
    expect(values(other)).toEqual([5, 2]);
    own.set('surface.b', 7);
    expect(overridesOf(other).fields.map(({ path, base }) => [path, base])).toEqual([
      ['Crate/ObjectRenderer.surface.b', 2],
    ]);
    // the prefab takes another value of the other one: both hold
    renderer.set('surface.a', 6);
    run(planApplyField(renderer, 'surface.a'));
    expect(values(other)).toEqual([6, 7]);
    expect(overridesOf(first).fields).toEqual([]);
    run(planApplyField(own, 'surface.b'));
    expect(values(first)).toEqual([6, 7]);
    own.set('surface.a', 1);
    expect(fieldOverride(own, 'surface.a')?.base).toBe(6);
    run(planRevertAll(other));
    expect(values(other)).toEqual([6, 7]);
  });

  test('go with the surface where an instance, or the prefab, wears another one', async () => {
    await loadSurfaceCode();
    scene.assets.addFieldAsset('surface', 'Rust', { source: text() });
    scene.assets.addFieldAsset('surface', 'Moss', { source: text() });
    const first = new GameObject('Crate');
    scene.add(first);
    const renderer = first.addComponent(ObjectRenderer, { surface: 'Rust' });
    renderer.set('surface.a', 5);
    const prefab = take(first);
    const other = place(prefab);
    renderer.surface = 'Moss';
    renderer.set('surface.b', 3);
    run(planApplyAll(first));
    expect(other.getComponent(ObjectRenderer)!.surface).toBe('Moss');
    expect(values(other)).toEqual([5, 3]);
    other.getComponent(ObjectRenderer)!.surface = null;
    expect(overridesOf(other).fields.map(({ path }) => path)).toEqual(['Crate/ObjectRenderer.surface']);
    run(planRevertAll(other));
    expect(values(other)).toEqual([5, 3]);
  });
});

describe('components of scripts, whose fields have changed since the prefab was made', () => {
  const keeping = new ComponentRegistry(builtinComponents.types.values(), { keepUnknown: true });
  const scriptOf = (fields: Parameters<typeof component>[0]) =>
    class extends component(fields) {
      static override readonly typeName: string = 'Spin';
    };
  const Fast = scriptOf({ rate: number(1, { help: '' }), far: boolean(false, { help: '' }) });
  const Named = scriptOf({ rate: string('slow', { help: '' }) });

  /** A prefab of the values that Fast has. */
  function spinning(): { spinner: GameObject; prefab: Prefab } {
    scene = new Scene({ registry: keeping });
    const spinner = new GameObject('Spinner');
    spinner.addComponent(Fast, { rate: 3, far: true });
    scene.add(spinner);
    return { spinner, prefab: take(spinner) };
  }

  test('an instance has what the new fields allow of the values', () => {
    keeping.register(Named);
    const { prefab } = spinning();
    const instance = instantiatePrefab(prefab, keeping);
    keeping.unregister(Named);
    expect(instance.components[1].authoredValues()).toEqual({ rate: 'slow' });
  });

  test('an instance of a script that is gone keeps values that the prefab has not', () => {
    const { spinner, prefab } = spinning();
    const unknown = keeping.createFrom({ type: 'Spin', version: 1, values: { rate: 4, more: 1 } });
    spinner.removeComponent(spinner.components[1]);
    spinner.addComponent(unknown, {}, { id: `${spinner.id}:Spin` });
    expect(overridesOf(spinner).fields.map(({ field }) => field)).toEqual(['rate']);
    run(planRevertAll(spinner));
    expect(unknown.authoredValues()).toEqual({ rate: 3, more: 1 });
    expect(prefab.objects).toHaveLength(1);
  });
});

test('weights of morph targets are overridden one by one, and go with another model', () => {
  const face = (): Model => {
    const mesh = new Mesh(new BoxGeometry());
    mesh.morphTargetDictionary = { Smile: 0, Blink: 1 };
    mesh.morphTargetInfluences = [0, 0];
    return new Model(mesh);
  };
  scene.assets.register('face.glb', face());
  scene.assets.register('other.glb', face());
  const first = new GameObject('Head');
  scene.add(first);
  const renderer = first.addComponent(ModelRenderer, { model: 'face.glb' });
  renderer.set('morph.Smile', 0.5);
  const other = place(take(first));
  const own = other.getComponent(ModelRenderer)!;
  const weights = (): unknown[] => [own.get('morph.Smile'), own.get('morph.Blink')];
  expect(weights()).toEqual([0.5, 0]);
  own.set('morph.Blink', 1);
  expect(overridesOf(other).fields.map(({ path, base }) => [path, base])).toEqual([
    ['Head/ModelRenderer.morph.Blink', 0],
  ]);
  renderer.set('morph.Smile', 0.75);
  run(planApplyField(renderer, 'morph.Smile'));
  expect(weights()).toEqual([0.75, 1]);
  own.model = 'other.glb';
  expect(overridesOf(other).fields.map(({ path }) => path)).toEqual([
    'Head/ModelRenderer.model',
    'Head/ModelRenderer.morphWeights',
  ]);
  run(planRevertAll(other));
  expect(weights()).toEqual([0.75, 0]);
});
