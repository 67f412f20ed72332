import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { createRandom, GameObject, Light } from '@farol/engine';
import { serialize } from '@farol/engine/files';
import { changePrefab, makePrefab } from '@farol/engine/prefabs';
import { expect, it } from 'vitest';
import { EditorDocument } from '../../model/EditorDocument';
import { canMoveTo, deleteObjects, duplicateObjects, moveObjects } from '../../model/edits';
import { assembleParts, type PartChange } from './parts';
import { describeSession } from './describeSession';
import { draftReason } from './draftReason';
import { PendingParts } from './PendingParts';
import { SceneDelta } from './SceneDelta';
import { SliceBudget } from './SliceBudget';
import type { SessionInfo } from '../../model/SessionInfo';

setFlagsFromString('--expose_gc');
const collect = runInNewContext('gc') as () => void;

const keep = (changes: readonly PartChange[], parts: Map<string, string>): number => {
  for (const [key, json] of changes) {
    if (json === null) parts.delete(key);
    else parts.set(key, json);
  }
  return changes.length;
};

const readAll = (delta: SceneDelta, parts: Map<string, string>): number => {
  let count = 0;
  while (!delta.isEmpty)
    count += keep(
      delta.read(() => true),
      parts,
    );
  return count;
};

it.each([1, 2, 3])('the stored parts make the very scene, after any changes, seed %i', (seed) => {
  const random = createRandom(seed);
  const document = new EditorDocument();
  const { scene, commands } = document;
  const all = (): GameObject[] => {
    const list: GameObject[] = [];
    scene.traverse((object) => list.push(object));
    return list;
  };
  for (let i = 0; i < 60; i++) {
    const parents = [scene, ...all()];
    parents[Math.floor(random() * parents.length)].add(new GameObject(`Object ${i}`));
  }
  const delta = new SceneDelta(scene);
  document.sceneChanged.subscribe((change) => delta.note(change));
  delta.noteAll();
  const parts = new Map<string, string>();
  for (let i = 0; i < 120; i++) {
    const objects = all();
    const object = objects[Math.floor(random() * objects.length)];
    const act = random();
    if (!object) commands.undo();
    else if (act < 0.2 && objects.length > 40) commands.run(deleteObjects(scene, [object]));
    else if (act < 0.4) commands.run(duplicateObjects(scene, [object]));
    else if (act < 0.6) commands.run(moveObjects(scene, [object], scene, 0));
    else if (act < 0.7 && canMoveTo([object], objects[0])) commands.run(moveObjects(scene, [object], objects[0]));
    else if (act < 0.8 && !object.getComponent(Light)) object.addComponent(Light);
    else if (act < 0.9) object.transform.position = [random(), 0, 0];
    else if (act < 0.95) commands.undo();
    else changePrefab(scene, makePrefab(object, 'Some', scene.prefabs.list[0]?.id).prefab);
    // stores some of the noted changes, sometimes all
    if (random() < 0.05) readAll(delta, parts);
    else
      for (let count = random() * 6; count > 1; count--)
        keep(
          delta.read(() => true),
          parts,
        );
  }
  readAll(delta, parts);
  expect(assembleParts(parts)).toEqual(JSON.parse(JSON.stringify(serialize(scene))));
});

it('reads what changed, and nothing else', () => {
  const document = new EditorDocument();
  const { scene } = document;
  for (let i = 0; i < 1000; i++) scene.add(new GameObject(`Object ${i}`));
  const delta = new SceneDelta(scene);
  document.sceneChanged.subscribe((change) => delta.note(change));
  scene.roots[5].transform.position = [1, 2, 3];
  scene.roots[5].name = 'Other';
  const parts = new Map<string, string>();
  expect(readAll(delta, parts)).toBe(1);
  expect([...parts.keys()]).toEqual([`o/${scene.roots[5].id}`]);
});

it('objects that are removed before they are read are let go', async () => {
  const { scene, sceneChanged } = new EditorDocument();
  const delta = new SceneDelta(scene);
  sceneChanged.subscribe((change) => delta.note(change));
  const comeAndGo = (): WeakRef<GameObject> => {
    const object = new GameObject('Passing');
    scene.add(object);
    scene.remove(object);
    return new WeakRef(object);
  };
  const gone = Array.from({ length: 20 }, comeAndGo);
  // lets the engine release weak references, which it keeps until the task ends
  await new Promise((resolve) => setImmediate(resolve));
  collect();
  // one may still be referenced from the stack
  expect(gone.filter((each) => each.deref() !== undefined).length).toBeLessThan(2);
  expect(delta.isEmpty).toBe(false);
});

it('reads a large prefab in pieces, and forgets those that it has no more', () => {
  const { scene } = new EditorDocument();
  const delta = new SceneDelta(scene);
  const parts = new Map<string, string>();
  const store = (count: number): void => {
    const objects = Array.from({ length: count }, (_, i) => ({
      ...{ id: `o${i}`, name: `Object ${i}`, components: [] },
      parent: i === 0 ? null : 'o0',
    }));
    scene.prefabs.set({ id: 'o0', name: 'Large', objects });
    delta.note({ kind: 'prefab', id: 'o0' });
    readAll(delta, parts);
  };
  const pieces = (): string[] => [...parts.keys()].filter((key) => key.startsWith('r/')).toSorted();
  delta.noteAll();
  store(250);
  expect(pieces()).toEqual(['r/o0/0', 'r/o0/1', 'r/o0/2']);
  expect(assembleParts(parts).prefabs).toEqual(scene.prefabs.list);
  store(120);
  expect(pieces()).toEqual(['r/o0/0', 'r/o0/1']);
  expect(assembleParts(parts).prefabs![0].objects).toHaveLength(120);
  scene.prefabs.delete('o0');
  delta.note({ kind: 'prefab', id: 'o0' });
  readAll(delta, parts);
  expect([...parts.keys()].filter((key) => /^[pr]\//.test(key))).toEqual([]);
});

it('says which part is missing of a damaged store', () => {
  expect(() => assembleParts(new Map([['c/', '["a"]']]))).toThrow("The part 'o/a' of the autosave is missing.");
});

it('a write that is refused is kept for the next, less what came anew', async () => {
  const pending = new PendingParts();
  pending.addParts([
    ['o/a', 'old'],
    ['o/b', 'b'],
  ]);
  pending.addFile('assets/x', null);
  const refuse = (): Promise<void> => {
    pending.addParts([['o/a', 'new']]);
    return Promise.reject(new DOMException('', 'QuotaExceededError'));
  };
  await expect(pending.store(refuse)).rejects.toMatchObject({ name: 'QuotaExceededError' });
  let stored: unknown = null;
  await pending.store(async (parts, files) => {
    stored = [Object.fromEntries(parts), [...files.keys()]];
  });
  expect(stored).toEqual([{ 'o/a': 'new', 'o/b': 'b' }, ['assets/x']]);
  await pending.store(async ({ size }) => expect(size).toBe(0));
});

it.each([
  [new DOMException('', 'QuotaExceededError'), 'it has no room left for this page; free space on the disk.'],
  [{ name: 'QuotaExceededError', message: '' }, 'it has no room left for this page; free space on the disk.'],
  [new DOMException('', 'ConstraintError'), 'the browser gives no reason but ConstraintError.'],
  [new Error('Internal error.'), 'internal error.'],
])('the reason of a refused draft is a sentence: %s', (error, sentence) => {
  expect(draftReason(error)).toBe(sentence);
});

it('drafts of one scene and minute are told apart by seconds, objects and the last edit', () => {
  const session: SessionInfo = {
    ...{ id: 'a', name: 'Untitled', fileName: null, handle: null, time: 1_700_000_000_000, isDirty: true },
    ...{ objects: 4, edit: 'Add Torus' },
  };
  const others = [
    { time: session.time + 1000 },
    { objects: 1 },
    { edit: 'Set x' },
    { fileName: 'a.farol' },
    { edit: null },
  ];
  const lines = [session, ...others.map((other) => ({ ...session, ...other }))].map(describeSession);
  expect(new Set(lines).size).toBe(lines.length);
  expect(lines[0]).toContain('4 objects · last edit: Add Torus');
  expect(lines[2]).toContain('1 object ·');
  // autosaves of earlier versions lack these fields
  expect(describeSession({ ...session, objects: undefined, edit: undefined })).not.toMatch(/object|edit/);
});

it('a slice takes 1 ms, a little more when a change has waited, and whatever is needed when it has for long', () => {
  const budget = new SliceBudget();
  budget.begin();
  expect([budget.of(50, 0), budget.of(0.5, 100), budget.of(50, 400)]).toEqual([1, 0.5, 3]);
  expect([5100, 5200, 5300].map((late) => budget.of(0, late))).toEqual([6, 12, 24]);
  expect([budget.most(), budget.most(), budget.most()]).toEqual([8, 16, 32]);
});
