import { GameObject, Light, Scene } from '@farol/engine';
import { parseFile, serialize } from '@farol/engine/files';
import { expect, test } from 'vitest';
import { copyObjects, pasteObjects } from './clip';
import { deleteObjects, duplicateObjects, moveObjects, setActive } from './edits';
import { groupObjects, ungroupObjects } from './groupObjects';
import { UniqueNames } from './UniqueNames';

/** Seconds that hold on a slow and busy machine. */
function quickly<T>(run: () => T, seconds = 5): T {
  const start = performance.now();
  const result = run();
  expect((performance.now() - start) / 1000).toBeLessThan(seconds);
  return result;
}

function sceneOf(count: number, name: (i: number) => string): Scene {
  const scene = new Scene();
  for (let i = 0; i < count; i++) scene.add(new GameObject(name(i)));
  return scene;
}

test('numbered names are numbered on in time that grows with them alone', () => {
  const count = 10_000;
  const names = new UniqueNames(sceneOf(count, (i) => `Box ${i + 1}`));
  const given = quickly(() => Array.from({ length: count }, (_, i) => names.take(`Box ${i + 1}`)));
  expect(new Set(given).size).toBe(count);
  expect([given[0], given.at(-1)]).toEqual(['Box 10001', 'Box 20000']);
});

test('very many objects are deleted, brought back, copied, hidden, moved, grouped and taken out of groups', () => {
  const count = 8000;
  const scene = sceneOf(count, () => 'Box');
  const all = [...scene.roots];
  const steps = {
    delete: () => deleteObjects(scene, scene.roots),
    duplicate: () => duplicateObjects(scene, scene.roots),
    hide: () => setActive(scene.roots, false),
    group: () => groupObjects(scene, scene.roots),
  };
  for (const [name, make] of Object.entries(steps)) {
    const start = performance.now();
    const command = make();
    command.do();
    command.undo();
    command.do();
    command.undo();
    expect([name, Math.floor((performance.now() - start) / 10_000)]).toEqual([name, 0]);
    expect(scene.roots).toEqual(all);
  }
  const parent = new GameObject('Parent');
  scene.add(parent);
  const move = moveObjects(scene, all, parent);
  quickly(() => move.do(), 10);
  expect(parent.children).toHaveLength(count);
  const ungroup = ungroupObjects(scene, [parent]);
  quickly(() => ungroup.do(), 10);
  expect(scene.roots).toEqual(all);
  quickly(() => scene.dispose());
});

test('objects that name others which are not copied are pasted in time that grows with them alone', () => {
  const count = 5000;
  const scene = sceneOf(count + 1, (i) => `Object ${i}`);
  const target = scene.roots[count];
  for (const root of scene.roots.slice(0, count)) root.addComponent('EventTrigger', { target: target.id });
  const { text } = copyObjects(scene, scene.roots.slice(0, count));
  const command = quickly(() => pasteObjects(scene, text, scene, []), 10);
  command.do();
  expect(scene.roots.at(-1)!.getComponent('EventTrigger')!.getAuthored('target')).toBe(target.id);
});

test('a text of the clipboard that is broken is refused in words, and nothing comes into a scene that its file cannot hold', () => {
  const scene = new Scene();
  const lamp = new GameObject('Lamp');
  lamp.addComponent(Light);
  scene.add(lamp);
  const { text } = copyObjects(scene, [lamp]);
  const clip = JSON.parse(text) as Record<string, unknown> & { objects: Record<string, unknown>[] };
  const component = (clip.objects[0].components as unknown[])[1] as object;
  const broken: object[] = [
    { ...clip, naming: { Light: { objects: 5, assets: 5 } } },
    { ...clip, naming: 'x' },
    { ...clip, naming: null },
    { ...clip, worlds: [Array.from({ length: 16 }, () => 'x')] },
    { ...clip, worlds: { length: 3 } },
    { ...clip, prefabs: [null, { id: 'p', objects: [null] }] },
    { ...clip, prefabs: [{ id: 'p', name: 'p', objects: [{ id: 'p', prefab: 5 }] }] },
    { ...clip, assets: null },
    { ...clip, objects: [{ ...clip.objects[0], components: [null, component] }] },
    { ...clip, objects: [{ ...clip.objects[0], components: [{ ...component, values: null }] }] },
    { ...clip, objects: [{ ...clip.objects[0], components: [{ ...component, type: 'constructor' }] }] },
    { ...clip, objects: [{ ...clip.objects[0], prefab: null }] },
  ];
  const texts = [
    ...broken.map((each) => JSON.stringify(each)),
    text.replace(/"worlds":\[\[.*?\]\]/, `"worlds":[[${Array.from({ length: 16 }, () => '1e400').join()}]]`),
  ];
  for (const each of texts) {
    const other = new Scene();
    let said = '';
    try {
      pasteObjects(other, each, other, []).do();
    } catch (error) {
      expect(error).toMatchObject({ name: 'FileError' });
      said = (error as Error).message;
    }
    expect(said.length).toBeLessThan(2000);
    expect(() => parseFile(JSON.stringify(serialize(other)))).not.toThrow();
  }
});
