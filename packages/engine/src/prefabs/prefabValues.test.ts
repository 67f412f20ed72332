import { boolean, number, string } from '@farol/editing/fields';
import { BoxGeometry, Mesh } from 'three';
import { beforeEach, describe, expect, test } from 'vitest';
import { Model } from '../assets/Model';
import { surfaceCode } from '../assets/surfaceCode';
import { ModelRenderer } from '../components/ModelRenderer';
import { ObjectRenderer } from '../components/ObjectRenderer';
import { GameObject } from '../core/GameObject';
import { component } from '../core/Component';
import { ComponentRegistry } from '../core/ComponentRegistry';
import { builtinComponents } from '../components/index';
import { planApplyAll, planApplyField, planRevertAll } from './applyOverrides';
import { instantiatePrefab } from './instantiatePrefab';
import { fieldOverride, overridesOf } from './overrides';
import type { Prefab } from '../core/Prefab';
import { newScene, place, run, scene, take } from './testing/prefabScene';

beforeEach(() => newScene());

describe('the values of a surface that an object wears by itself', () => {
  const text = (more = ''): string =>
    `uniform float a; // = 1\nuniform float b; // = 2\n${more}void surface(inout SurfaceData s) {}`;
  const values = (root: GameObject): unknown[] => {
    const renderer = root.getComponent(ObjectRenderer)!;
    return [renderer.get('surface.a'), renderer.get('surface.b')];
  };

  test('are overridden one by one', async () => {
    await surfaceCode.load();
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
    // the prefab changes the other value: both changes are kept
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
    await surfaceCode.load();
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

  /** A prefab with the values of Fast. */
  function spinning(): { spinner: GameObject; prefab: Prefab } {
    newScene(keeping);
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
