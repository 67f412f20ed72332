import { type Command, SetFields } from '@farol/editing';
import { createRandom, GameObject, Light, type Scene } from '@farol/engine';
import { instanceRootOf, instantiatePrefab } from '@farol/engine/prefabs';
import { expect, it } from 'vitest';
import { addObject, deleteObjects, duplicateObjects } from './edits';
import { EditorDocument } from './EditorDocument';
import {
  applyField,
  applyInstance,
  canPlacePrefab,
  createPrefab,
  deletePrefab,
  revertInstance,
  unpackInstance,
} from './prefabEdits';

type Random = () => number;
const pick = <T>(random: Random, list: readonly T[]): T => list[Math.floor(random() * list.length)];

function objectsOf(scene: Scene): GameObject[] {
  const all: GameObject[] = [];
  scene.traverse((object) => all.push(object));
  return all;
}

function randomCommand(random: Random, { scene }: EditorDocument): Command | null {
  const all = objectsOf(scene);
  const object = all.length > 0 ? pick(random, all) : null;
  const root = object && instanceRootOf(object);
  const kind = all.length < 4 ? 0 : all.length > 60 ? 9 : Math.floor(random() * 10);
  const light = object?.getComponent(Light);
  if (kind === 0) {
    const added = new GameObject(`Object ${Math.floor(random() * 1000)}`);
    added.addComponent(Light);
    return addObject(scene, added, object && random() < 0.6 ? object : scene, []);
  }
  if (kind === 1 && object && (!root || root === object)) return createPrefab(scene, object, []);
  if (kind === 2 && scene.prefabs.list.length > 0) {
    const prefab = pick(random, scene.prefabs.list);
    const parent = object && random() < 0.5 && canPlacePrefab(scene, prefab, object) ? object : scene;
    const placed = instantiatePrefab(prefab, scene.registry);
    placed.transform.position = [random(), 0, 0];
    return addObject(scene, placed, parent, []);
  }
  if ((kind === 3 || kind === 4) && light) {
    return new SetFields('Set', [{ owner: light, name: 'intensity', value: Math.floor(random() * 4) }]);
  }
  if (kind === 5 && root) return applyInstance(scene, root, []);
  if (kind === 6 && root && light) return applyField(scene, light, 'intensity', []);
  if (kind === 7 && root) return revertInstance(scene, root, []);
  if (kind === 8 && root && random() < 0.3) return unpackInstance(scene, root, []);
  if (kind === 8 && scene.prefabs.list.length > 0) return deletePrefab(scene, pick(random, scene.prefabs.list), []);
  if (kind === 9 && object) return random() < 0.7 ? deleteObjects(scene, [object]) : duplicateObjects(scene, [object]);
  return null;
}

it.each([1, 2, 3, 4])('undoes and redoes random work with prefabs exactly, seed %i', (seed) => {
  const random = createRandom(seed);
  const document = new EditorDocument();
  const { commands } = document;
  const states = [document.serialize()];
  let steps = 0;
  for (let i = 0; i < 400; i++) {
    if (random() < 0.15) steps -= commands.undo() ? 1 : 0;
    else if (random() < 0.1) steps += commands.redo() ? 1 : 0;
    else {
      const before = commands.history.length;
      try {
        const command = randomCommand(random, document);
        if (command) commands.run(command);
      } catch (error) {
        // the only error that random edits may cause
        expect(String(error)).toMatch(/would hold itself|is not there|already/);
      }
      if (commands.history.length > before) states.splice(++steps, Infinity, document.serialize());
    }
    expect(document.serialize()).toBe(states[steps]);
  }
  while (commands.undo()) expect(document.serialize()).toBe(states[--steps]);
  while (commands.redo()) expect(document.serialize()).toBe(states[++steps]);
  expect(steps).toBe(states.length - 1);
});
