import type { Command } from '@farol/editing';
import { GameObject, Light, Scene } from '@farol/engine';
import { parseFile, serialize } from '@farol/engine/files';
import { growthOf } from '@farol/tools/workOf';
import { expect, test } from 'vitest';
import { copyObjects, pasteObjects } from './clip';
import { deleteObjects, duplicateObjects, moveObjects, setActive } from './edits';
import { groupObjects, ungroupObjects } from './groupObjects';
import { UniqueNames } from './UniqueNames';

/** Largest growth of work for four times as many objects: linear, with some slack. */
const LINEAR = 4.5;

function sceneOf(count: number, name: (i: number) => string): Scene {
  const scene = new Scene();
  for (let i = 0; i < count; i++) scene.add(new GameObject(name(i)));
  return scene;
}

test('numbered names are numbered on by work that grows with them alone', async () => {
  let given: string[] = [];
  const growth = await growthOf(1000, (count) => {
    const names = new UniqueNames(sceneOf(count, (i) => `Box ${i + 1}`));
    return () => (given = Array.from({ length: count }, (_, i) => names.take(`Box ${i + 1}`)));
  });
  expect(growth).toBeLessThan(LINEAR);
  expect(new Set(given).size).toBe(4000);
  expect([given[0], given.at(-1)]).toEqual(['Box 4001', 'Box 8000']);
});

const edits: Record<string, (scene: Scene) => Command> = {
  delete: (scene) => deleteObjects(scene, scene.roots),
  duplicate: (scene) => duplicateObjects(scene, scene.roots),
  hide: (scene) => setActive(scene.roots, false),
  group: (scene) => groupObjects(scene, scene.roots),
};

test.each(Object.entries(edits))('many objects, and an edit of all of them: %s', async (_, make) => {
  const growth = await growthOf(300, (count) => {
    const scene = sceneOf(count, () => 'Box');
    const all = [...scene.roots];
    return () => {
      const command = make(scene);
      command.do();
      command.undo();
      command.do();
      command.undo();
      if (scene.roots.some((root, i) => root !== all[i])) throw new Error('It is not undone.');
    };
  });
  expect(growth).toBeLessThan(LINEAR);
});

test('many objects are moved, taken out of their group and disposed of', async () => {
  const made = (count: number) => {
    const scene = sceneOf(count, () => 'Box');
    const all = [...scene.roots];
    const parent = new GameObject('Parent');
    scene.add(parent);
    return { scene, all, parent, move: moveObjects(scene, all, parent) };
  };
  expect(
    await growthOf(300, (count) => {
      const { move } = made(count);
      return () => move.do();
    }),
  ).toBeLessThan(LINEAR);
  expect(
    await growthOf(300, (count) => {
      const { scene, all, parent, move } = made(count);
      move.do();
      expect(parent.children).toHaveLength(count);
      return () => {
        ungroupObjects(scene, [parent]).do();
        if (scene.roots.some((root, i) => root !== all[i])) throw new Error('They are not where they were.');
      };
    }),
  ).toBeLessThan(LINEAR);
  expect(await growthOf(300, (count) => () => made(count).scene.dispose())).toBeLessThan(LINEAR);
});

test('objects that name others which are not copied are pasted by work that grows with them alone', async () => {
  const growth = await growthOf(250, (count) => {
    const scene = sceneOf(count + 1, (i) => `Object ${i}`);
    const target = scene.roots[count];
    for (const root of scene.roots.slice(0, count)) root.addComponent('EventTrigger', { target: target.id });
    const { text } = copyObjects(scene, scene.roots.slice(0, count));
    return () => {
      pasteObjects(scene, text, scene, []).do();
      expect(scene.roots.at(-1)!.getComponent('EventTrigger')!.getAuthored('target')).toBe(target.id);
    };
  });
  expect(growth).toBeLessThan(LINEAR);
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
