import { currentOf } from '@farol/editing';
import { expect, test, vi } from 'vitest';
import { Animation } from '../components/Animation';
import { builtinComponents } from '../components/index';
import { addClip, keys, track } from '../components/testing/clipStage';
import type { Component } from '../core/Component';
import { ComponentRegistry } from '../core/ComponentRegistry';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import { UnknownComponent } from '../core/UnknownComponent';
import { serialize } from '../files/serialize';
import { SceneScripts } from './SceneScripts';
import { inNode } from './testing/inNode';

const spin = (
  fields: string,
  body: string,
): string => `import { component, number, string } from '@farol/engine/fields';
const help = 'For a test.';
export default class Spin extends component({ ${fields} }) {
  private turned = 0;
  #calls = 0;
  override update(deltaSeconds: number): void {
    ${body}
  }
}
`;

const plain = spin('rate: number(1, { help })', 'this.turned += this.rate * deltaSeconds; this.#calls++;');
const fast = spin('rate: number(2, { help })', '');

async function make(
  sources: Record<string, string>,
  options = inNode,
): Promise<{ scene: Scene; scripts: SceneScripts }> {
  const registry = new ComponentRegistry(builtinComponents.types.values(), { keepUnknown: true });
  const scene = new Scene({ registry });
  for (const [name, source] of Object.entries(sources)) scene.assets.addFieldAsset('script', name, { source });
  const scripts = new SceneScripts(scene, registry, options);
  await scripts.settled();
  return { scene, scripts };
}

const edit = async (scene: Scene, scripts: SceneScripts, name: string, source: string): Promise<void> => {
  scene.assets.fieldAsset(name)!.set('source', source);
  await scripts.settled();
};

const addSpin = (scene: Scene, values = {}): Component => {
  const object = new GameObject('Top');
  scene.add(object);
  return object.addComponent('Spin', values);
};

const problems = ({ errors }: SceneScripts): string[] => [...errors.values()].map(({ message }) => message);

test('the class of a script is a component of the scene, and of no other', async () => {
  const { scene, scripts } = await make({ 'Scripts/Spin': plain });
  expect(problems(scripts)).toEqual([]);
  const component = addSpin(scene, { rate: 3 });
  scene.update(0.5);
  expect(component).toMatchObject({ typeName: 'Spin', turned: 1.5 });
  expect(scripts.scriptOf(component.componentClass)).toBe('Scripts/Spin');
  expect(builtinComponents.types.has('Spin')).toBe(false);
});

test('an edit keeps 200 components, their ids and the values of their fields, and compiles once', async () => {
  const compile = vi.fn<typeof inNode.compile>(inNode.compile);
  const { scene, scripts } = await make({ Spin: plain }, { ...inNode, compile });
  compile.mockClear();
  const components = Array.from({ length: 200 }, (_, i) => addSpin(scene, { rate: i }));
  const ids = components.map(({ id }) => id);
  scene.update(1);
  await edit(
    scene,
    scripts,
    'Spin',
    spin('rate: number(2, { help }), name: string("a", { help })', 'this.turned = 7;'),
  );
  scene.update(1);
  expect(components.map((each) => currentOf(each).get('rate'))).toEqual(ids.map((_, i) => (i === 1 ? 2 : i)));
  expect(components.every((each) => (currentOf(each) as Component & { turned: number }).turned === 7)).toBe(true);
  expect(components.map((each) => currentOf(each).id)).toEqual(ids);
  expect(scene.componentsOf('Spin')).toHaveLength(200);
  expect(compile).toHaveBeenCalledTimes(1);
});

test('a broken text leaves the last good class running, and is told with its line', async () => {
  const { scene, scripts } = await make({ Spin: plain });
  const component = addSpin(scene, { rate: 3 }) as Component & { turned: number };
  for (const broken of [plain.replace('this.#calls++', 'this.#calls+'), plain.replace('const help', 'cnst help'), '']) {
    await edit(scene, scripts, 'Spin', broken);

    currentOf(component).turned = 0;
    scene.update(1);
    expect(currentOf(component)).toMatchObject({ turned: 3, rate: 3 });
  }
  await edit(scene, scripts, 'Spin', plain);
  expect(problems(scripts)).toEqual([]);
});

test('texts and values that are taken back one by one give what there was: a default stays one', async () => {
  const { scene, scripts } = await make({ Spin: plain });
  const component = addSpin(scene);
  await edit(scene, scripts, 'Spin', fast);
  currentOf(component).set('rate', 3);
  await edit(scene, scripts, 'Spin', `${fast}// more`);
  await edit(scene, scripts, 'Spin', fast);
  expect(currentOf(component).get('rate')).toBe(3);
  currentOf(component).set('rate', 2);
  await edit(scene, scripts, 'Spin', plain);
  expect(currentOf(component).get('rate')).toBe(1);
  await edit(scene, scripts, 'Spin', fast);
  expect(currentOf(component).get('rate')).toBe(2);
});

test('without its script a component is data, and is itself again when the script is back', async () => {
  const { scene, scripts } = await make({ Spin: plain });
  const component = addSpin(scene, { rate: 3 });
  const before = JSON.stringify(serialize(scene).objects);
  const taken = scene.assets.take('Spin');
  expect(currentOf(component)).toBeInstanceOf(UnknownComponent);
  expect(JSON.stringify(serialize(scene).objects)).toBe(before);
  scene.assets.restore(taken);
  expect(currentOf(component).componentClass).toBe(scripts.classOf('Spin'));
  expect(currentOf(component).get('rate')).toBe(3);
  scripts.isOn = false;
  expect(currentOf(component)).toBeInstanceOf(UnknownComponent);
  scripts.isOn = true;
  expect(currentOf(component).componentClass).toBe(scripts.classOf('Spin'));
});

test('a script without a class any more leaves the one that there was', async () => {
  const { scene, scripts } = await make({ Spin: plain });
  const component = addSpin(scene);
  await edit(scene, scripts, 'Spin', plain.replace('export default ', ''));
  expect(problems(scripts)).toEqual([
    'Spin, line 3: it exports no class: write `export default class … extends component({ … })`.',
  ]);
  expect(currentOf(component).componentClass).toBe(scripts.classOf('Spin'));
});

test('fields need no help; what they cannot begin with is told by the name of the field, and the class before runs on', async () => {
  const { scene, scripts } = await make({ Spin: spin('rate: number(1), name: string("a")', '') });
  const component = addSpin(scene, { rate: 3 });
  expect(currentOf(component).fields.rate).toEqual({ kind: 'number', default: 1, help: '' });
  await edit(scene, scripts, 'Spin', spin('rate: number(), name: string("a")', ''));
  expect(problems(scripts)).toEqual([
    "Spin, line 3: the default of its field 'rate' must be a finite number, not nothing.",
  ]);
  expect(currentOf(component).get('rate')).toBe(3);
});

test('a broken text runs the class that it had when it was typed, also where undo comes to it from another one', async () => {
  const broken = 'export default class {';
  const { scene, scripts } = await make({ Spin: plain, Late: broken });
  const component = addSpin(scene);
  const savedNow = (): string => JSON.stringify(serialize(scene).objects);
  await edit(scene, scripts, 'Spin', broken);
  const saved = savedNow();
  await edit(scene, scripts, 'Spin', spin('rate: number(2, { help })', ''));
  expect(currentOf(component).get('rate')).toBe(2);
  await edit(scene, scripts, 'Spin', broken);
  expect(currentOf(component).get('rate')).toBe(1);
  expect(savedNow()).toBe(saved);
  expect(problems(scripts)).toHaveLength(2);
  // a script that has never compiled has no class, and after another error still none
  await edit(scene, scripts, 'Late', plain.replaceAll('Spin', 'Late'));
  expect(scripts.classOf('Late')).not.toBeNull();
  await edit(scene, scripts, 'Late', broken);
  expect(scripts.classOf('Late')).toBeNull();
});

/** A script that refers to the Spin of its object in a property and in an array. */
const holder = `import { component } from '@farol/engine/fields';
export default class Holder extends component({}) {
  spin = null;
  spins = [];
  start() {
    this.spin = this.gameObject.getComponent('Spin');
    this.spins = this.gameObject.getComponents('Spin');
  }
}
`;

test("while the scene plays, a script's properties hold the components that replace those they held", async () => {
  const { scene, scripts } = await make({ Spin: plain, Holder: holder });
  const component = addSpin(scene, { rate: 3 });
  const held = component.gameObject.addComponent('Holder') as Component & { spin: Component; spins: Component[] };
  scene.update(1);
  expect(held.spin).toBe(component);
  await edit(scene, scripts, 'Spin', fast);
  scene.update(1);
  expect(currentOf(held)).toBe(held);
  expect(held.spin).toBe(currentOf(component));
  expect(held.spins).toEqual([held.gameObject.getComponent('Spin')]);
  expect(held.spin.isAttached).toBe(true);
});

test("a clip goes on writing a script's field, in the first frame after an edit too", async () => {
  const { scene, scripts } = await make({ Spin: plain });
  const component = addSpin(scene);
  addClip(scene, 'Rates', { tracks: [track('rate', keys([0, 5], [2, 5]), '', 'Spin')] });
  component.gameObject.addComponent(Animation, { clip: 'Rates' });
  scene.update(0.5);
  expect(component.get('rate')).toBe(5);
  await edit(scene, scripts, 'Spin', fast);
  scene.update(0.5);
  expect(currentOf(component).get('rate')).toBe(5);
});
