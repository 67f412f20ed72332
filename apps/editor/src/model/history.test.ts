import {
  builtinComponents,
  createRandom,
  type Field,
  type FieldOwner,
  type FieldValue,
  GameObject,
  instanceRootOf,
  Light,
  Scene,
  scenes,
  serialize,
} from '@farol/engine';
import { createHash } from 'node:crypto';
import { describe, expect, it } from 'vitest';
import { copyObjects, pasteObjects } from './clip';
import type { Command } from './Command';
import type { Container } from './commands/Placement';
import { SetFields } from './commands/SetFields';
import { SetMicroShaders } from './commands/SetMicroShaders';
import { SetProperty } from './commands/SetProperty';
import {
  addComponent,
  addObject,
  canMoveTo,
  deleteObjects,
  duplicateObjects,
  moveComponents,
  moveObjects,
  removeComponents,
  renameObject,
  resetFields,
  setActive,
  setEnabled,
  setLocked,
  setValues,
} from './edits';
import { EditorDocument } from './EditorDocument';
import { groupObjects, ungroupObjects } from './groupObjects';
import {
  applyField,
  canPlacePrefab,
  createPrefab,
  deletePrefab,
  placePrefab,
  renamePrefab,
  revertInstance,
  unpackInstance,
} from './prefabEdits';

type Random = () => number;
const below = (random: Random, count: number): number => Math.floor(random() * count);
const pick = <T>(random: Random, list: readonly T[]): T => list[below(random, list.length)];

function objectsOf(scene: Scene): GameObject[] {
  const all: GameObject[] = [];
  scene.traverse((object) => all.push(object));
  return all;
}

/** A value that the field allows. */
function randomValue(random: Random, field: Field, document: EditorDocument): FieldValue {
  const between = (min = -20, max = 20): number => min + random() * (Math.min(max, min + 1000) - min);
  switch (field.kind) {
    case 'number':
      return field.integer ? Math.ceil(between(field.min, field.max)) : between(field.min, field.max);
    case 'angle':
      return between(field.min, field.max);
    case 'boolean':
      return random() < 0.5;
    case 'string':
      return `text ${below(random, 100)}`;
    case 'choice':
      return pick(random, field.options);
    case 'vector3':
      return [between(field.min, field.max), between(field.min, field.max), between(field.min, field.max)];
    case 'euler':
      return [between(-4, 4), between(-4, 4), between(-4, 4)];
    case 'colour':
      return [random(), random(), random() * 3];
    case 'asset': {
      const names = document.assets.list(field.assetType).filter((name) => name !== 'dragon' && !name.includes('/'));
      return names.length === 0 || random() < 0.2 ? null : pick(random, names.slice(0, 6));
    }
    case 'custom':
      return field.default;
    case 'object':
      return random() < 0.3 ? null : pick(random, objectsOf(document.scene)).id;
  }
}

function randomEdit(random: Random, document: EditorDocument, owner: FieldOwner): SetFields {
  const name = pick(random, Object.keys(owner.fields));
  return new SetFields(`Set ${name}`, [{ owner, name, value: randomValue(random, owner.fields[name], document) }]);
}

/** Some objects, often nested ones. */
const some = (random: Random, all: readonly GameObject[]): GameObject[] => {
  const chosen = all.filter(() => random() < 2 / all.length);
  return chosen.length > 0 ? chosen : [pick(random, all)];
};

function randomMicroShaders(random: Random, { scene }: EditorDocument): Command {
  const names = ['heatMap', 'own/a', 'own/b'].filter(() => random() < 0.6);
  const text = (): string | null => (random() < 0.3 ? null : `float v${below(random, 1000)};`);
  return new SetMicroShaders(
    'Edit microshaders',
    scene,
    names.map((name) => ({ name, text: text() })),
  );
}

/** Work with prefabs; where an object is in no instance, it becomes one. */
function randomPrefabCommand(
  random: Random,
  { scene }: EditorDocument,
  object: GameObject,
  parent: Container,
): Command {
  const root = instanceRootOf(object);
  if (!root) return createPrefab(scene, object, []);
  const prefab = pick(random, scene.prefabs.list);
  switch (below(random, 6)) {
    case 0:
      return placePrefab(scene, prefab, canPlacePrefab(scene, prefab, parent) ? parent : scene, [], [random(), 0, 0]);
    case 1:
      return applyField(scene, object.transform, 'scale', []);
    case 2:
      return revertInstance(scene, root, []);
    case 3:
      return unpackInstance(scene, root, []);
    case 4:
      return deletePrefab(scene, prefab, []);
    default:
      return renamePrefab(scene, prefab, `Prefab ${below(random, 100)}`);
  }
}

function randomCommand(random: Random, document: EditorDocument): Command {
  const { scene, selection } = document;
  const all = objectsOf(scene);
  const parent = (): Container => (all.length === 0 || random() < 0.3 ? scene : pick(random, all));
  const kind = all.length < 6 ? 0 : all.length > 40 ? 1 : below(random, 27);
  switch (kind) {
    case 0: {
      const object = new GameObject(`Object ${below(random, 1000)}`);
      if (random() < 0.7) {
        const type = pick(random, [...builtinComponents.types.values()].slice(1));
        object.addComponent(type);
      }
      return addObject(scene, object, parent(), selection.ids);
    }
    case 1:
      return deleteObjects(scene, some(random, all));
    case 2:
      return duplicateObjects(scene, some(random, all).slice(0, 2));
    case 3: {
      const target = parent();
      const objects = some(random, all);
      return canMoveTo(objects, target) ? moveObjects(scene, objects, target) : moveObjects(scene, objects, scene, 0);
    }
    case 4: {
      const object = pick(random, all);
      return moveObjects(scene, [object], object.parent ?? scene, below(random, 4));
    }
    case 5:
      return renameObject(pick(random, all), `Name ${below(random, 1000)}`);
    case 6:
      return setActive(some(random, all), random() < 0.5);
    case 7:
      return setEnabled(pick(random, all).components, random() < 0.5);
    case 8:
      return addComponent(scene, some(random, all), pick(random, [...builtinComponents.types.values()]));
    case 9:
      return removeComponents(
        scene,
        pick(random, all).components.filter((component) => component.typeName !== 'Transform'),
      );
    case 10:
      return randomEdit(random, document, scene.settings);
    case 11:
      return setLocked(some(random, all), random() < 0.5);
    case 12:
      return groupObjects(scene, some(random, all));
    case 13:
      return ungroupObjects(scene, some(random, all));
    case 14:
      return pasteObjects(scene, copyObjects(scene, some(random, all).slice(0, 2)), parent(), selection.ids);
    case 15:
      return moveComponents(pick(random, all).components.slice(-1), random() < 0.5 ? -1 : 1);
    case 16: {
      const { components } = pick(random, all);
      const from = pick(random, components);
      const to = pick(random, all).components.filter(({ typeName }) => typeName === from.typeName);
      return setValues('Paste values', to, from.authoredValues());
    }
    case 17:
      return resetFields('Reset', [pick(random, pick(random, all).components)]);
    case 18:
      return randomMicroShaders(random, document);
    case 19:
      return new SetProperty('Rename scene', [scene], 'name', `Scene ${below(random, 100)}`);
    case 20:
      return new SetProperty(
        'Set camera',
        [scene],
        'activeCamera',
        scene.cameras[below(random, scene.cameras.length)] ?? null,
      );
    case 21:
    case 22:
    case 23:
    case 24:
    case 25:
      return randomPrefabCommand(random, document, pick(random, all), parent());
    default:
      return randomEdit(random, document, pick(random, pick(random, all).components));
  }
}

/** A drag of many previews, kept or not; sometimes of different commands. */
function randomGesture(random: Random, document: EditorDocument): void {
  const gesture = document.commands.begin();
  const owner = pick(random, objectsOf(document.scene))?.transform ?? document.scene.settings;
  for (let i = below(random, 4); i >= 0; i--) {
    if (random() < 0.7) gesture.preview(randomEdit(random, document, owner));
    else {
      gesture.reset();
      gesture.preview(randomCommand(random, document));
    }
  }
  if (random() < 0.6) gesture.commit();
  else gesture.discard();
}

function randomSimulation(random: Random, document: EditorDocument): void {
  const { simulation } = document;
  const act = below(random, 4);
  if (act === 0) simulation.play();
  else if (act === 1) simulation.step();
  else if (act === 2) simulation.stop();
  simulation.advance(random() * 0.2);
}

/** A scene with one object of each type of component, some below others. */
function startScene(random: Random, { assets }: EditorDocument): Scene {
  const scene = new Scene({ name: 'Start', assets });
  for (const type of [...builtinComponents.types.values()].slice(1)) {
    const object = new GameObject(type.typeName);
    object.addComponent(type);
    object.transform.position = [random() * 4, random(), random() * 4];
    object.transform.rotation = [0, random() * 6, 0];
    (random() < 0.5 ? scene : pick(random, [scene, ...objectsOf(scene)])).add(object);
  }
  return scene;
}

/** What a document is, short enough to remember thousands of. */
const stateOf = (document: EditorDocument): string =>
  createHash('sha1')
    .update(JSON.stringify(serialize(document.scene)))
    .digest('base64');

/** Steps of each seed: 10,000 in all. */
const STEPS = 2500;

describe('the history', () => {
  it.each([1, 2, 3, 4])(
    'undoes and redoes random edits exactly, seed %i',
    (seed) => {
      const random = createRandom(seed);
      const document = new EditorDocument();
      document.open(startScene(random, document));
      const { commands } = document;
      /** What the document was after each number of steps that the history still has. */
      const states = [stateOf(document)];
      let steps = 0;
      for (let i = 0; i < STEPS; i++) {
        const act = random();
        if (act < 0.15) steps -= commands.undo() ? 1 : 0;
        else if (act < 0.25) steps += commands.redo() ? 1 : 0;
        else if (act < 0.35) {
          randomSimulation(random, document);
          // stopping takes the steps back that were done since it played
          const taken = steps - commands.history.length;
          if (taken > 0) states.splice((steps -= taken) + 1);
        } else {
          const last = commands.last;
          if (act < 0.5) randomGesture(random, document);
          else commands.run(randomCommand(random, document));
          if (commands.last !== last) {
            states.splice(++steps, Infinity, stateOf(document));
            // the history keeps so many steps, and forgets the oldest
            while (steps > commands.history.length) {
              states.shift();
              steps--;
            }
          }
        }
        if (commands.history.length !== steps || stateOf(document) !== states[steps]) {
          expect.fail(`step ${i}: not what it was after '${commands.undoLabel}', before '${commands.redoLabel}'`);
        }
      }
      document.simulation.stop();
      if (commands.history.length < steps) states.splice((steps = commands.history.length) + 1);
      while (commands.undo()) expect(stateOf(document)).toBe(states[--steps]);
      expect(steps).toBe(0);
      while (commands.redo()) expect(stateOf(document)).toBe(states[++steps]);
      expect(steps).toBe(states.length - 1);
      // not all: stopping takes back what was done while it played
      expect(steps).toBeGreaterThan(200);
      for (const id of document.selection.ids) expect(document.scene.findById(id)).not.toBeNull();
    },
    20_000,
  );
});

describe('EditorDocument', () => {
  it('keeps a moved object where it is in the world', async () => {
    const document = new EditorDocument();
    const { scene } = document;
    const parent = new GameObject('Parent');
    parent.transform.position = [3, -1, 2];
    parent.transform.rotation = [0.3, 0.9, -0.2];
    const child = new GameObject('Child');
    child.transform.position = [1, 2, 3];
    scene.add(parent).add(child);
    const before = child.transform.modelMatrix.elements;
    document.commands.run(moveObjects(scene, [child], parent));
    expect(child.parent).toBe(parent);
    child.transform.modelMatrix.elements.forEach((value, i) => expect(value).toBeCloseTo(before[i], 9));
    expect(child.transform.position).not.toEqual([1, 2, 3]);
    document.commands.undo();
    expect(child.transform.position).toEqual([1, 2, 3]);
  });

  it('puts several objects in order before a sibling', () => {
    const { commands, scene } = new EditorDocument();
    const [a, b, c, d] = ['a', 'b', 'c', 'd'].map((name) => new GameObject(name));
    for (const object of [a, b, c, d]) scene.add(object);
    commands.run(moveObjects(scene, [b, a], scene, 1));
    expect(scene.roots.map(({ name }) => name)).toEqual(['c', 'a', 'b', 'd']);
    commands.undo();
    expect(scene.roots.map(({ name }) => name)).toEqual(['a', 'b', 'c', 'd']);
  });

  it('refuses nothing half: one wrong value of several changes none', () => {
    const { commands, scene } = new EditorDocument();
    const lights = [1, 2].map(() => new GameObject('Light').addComponent(Light));
    for (const light of lights) scene.add(light.gameObject);
    const edits = [
      { owner: lights[0], name: 'intensity', value: 5 },
      { owner: lights[1], name: 'intensity', value: Number.NaN },
    ];
    expect(() => commands.run(new SetFields('Set intensity', edits))).toThrow(/Light\.intensity/);
    expect(lights.map(({ intensity }) => intensity)).toEqual([1, 1]);
    expect(commands.history).toEqual([]);
  });

  it('selects again what an undo brings back, and forgets what is gone', () => {
    const { commands, scene, selection } = new EditorDocument();
    const object = new GameObject('Thing');
    scene.add(object);
    selection.set([object.id]);
    commands.run(deleteObjects(scene, [object]));
    expect(selection.ids).toEqual([]);
    commands.undo();
    expect(selection.ids).toEqual([object.id]);
    commands.run(duplicateObjects(scene, [object]));
    expect(selection.ids).toEqual([scene.roots[1].id]);
    commands.undo();
    expect(selection.ids).toEqual([object.id]);
  });

  it('stops to what was there before it played, edits made while playing included', async () => {
    const document = new EditorDocument();
    document.open(await scenes.temple.build({ lights: 2 }, document.assets));
    const light = document.scene.lights.find(({ type }) => type === 'point')!;
    const { transform } = light.gameObject;
    const authored = transform.position;
    document.simulation.play();
    document.simulation.advance(0.1);
    expect(transform.position).not.toEqual(authored);
    document.commands.run(new SetFields('Dim', [{ owner: light, name: 'intensity', value: 0.5 }]));
    const { intensity } = light;
    document.simulation.stop();
    expect(intensity).toBe(0.5);
    expect(transform.position).toEqual(authored);
    expect(light.intensity).not.toBe(0.5);
  });

  it('groups and ungroups objects where they are in the world', () => {
    const { commands, scene, selection } = new EditorDocument();
    const [a, b, c] = ['a', 'b', 'c'].map((name, i) => {
      const object = new GameObject(name);
      object.transform.position = [i * 2, 1, 0];
      object.transform.rotation = [0.2 * i, 0.4, 0];
      return object;
    });
    for (const object of [a, b, c]) scene.add(object);
    const worlds = [b, c].map(({ transform }) => transform.modelMatrix.elements);
    commands.run(groupObjects(scene, [c, b]));
    const group = scene.roots[1];
    expect(scene.roots.map(({ name }) => name)).toEqual(['a', 'Group']);
    expect(group.children.map(({ name }) => name)).toEqual(['b', 'c']);
    expect(group.transform.position).toEqual([3, 1, 0]);
    expect(selection.ids).toEqual([group.id]);
    const close = (): void =>
      [b, c].forEach(({ transform }, i) =>
        transform.modelMatrix.elements.forEach((value, j) => expect(value).toBeCloseTo(worlds[i][j], 9)),
      );
    close();
    commands.run(ungroupObjects(scene, [group]));
    expect(scene.roots.map(({ name }) => name)).toEqual(['a', 'b', 'c']);
    close();
    commands.undo();
    commands.undo();
    expect(b.transform.position).toEqual([2, 1, 0]);
  });

  it('pastes below another parent where it was, with ids of its own and references that hold', () => {
    const { commands, scene } = new EditorDocument();
    const [source, child, parent, outside] = ['Source', 'Child', 'Parent', 'Outside'].map(
      (name) => new GameObject(name),
    );
    source.transform.position = [1, 2, 3];
    parent.transform.position = [5, 0, 0];
    parent.transform.rotation = [0, 1, 0];
    for (const object of [source, parent, outside]) scene.add(object);
    source.add(child);
    const text = copyObjects(scene, [source]);
    commands.run(pasteObjects(scene, text, parent, []));
    const [copy] = parent.children;
    expect(copy.id).not.toBe(source.id);
    expect(copy.children.map(({ name }) => name)).toEqual(['Child']);
    copy.transform.worldPosition.toArray().forEach((value, i) => expect(value).toBeCloseTo([1, 2, 3][i], 9));
    expect(() => pasteObjects(scene, text.replace('"Transform"', '"Teleporter"'), scene, [])).toThrow(/Teleporter/);
    expect(() => pasteObjects(scene, 'text', scene, [])).toThrow(/clipboard/);
    expect(commands.history).toEqual(['Paste Source']);
  });
});
