import { SetFields } from '@farol/editing';
import { EventTrigger, GameObject, Light } from '@farol/engine';
import { scenes } from '@farol/scenes';
import { Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { copyObjects, pasteObjects } from './clip';
import { deleteObjects, duplicateObjects, moveObjects } from './edits';
import { EditorDocument } from './EditorDocument';
import { groupObjects, ungroupObjects } from './groupObjects';

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
    const light = document.scene.componentsOf(Light).find(({ type }) => type === 'point')!;
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

  it('tells the scene when it is held, and switches that triggers turned are back when it stops', () => {
    const { scene, simulation } = new EditorDocument();
    const object = new GameObject('Lamp');
    const light = object.addComponent(Light);
    object.addComponent(EventTrigger, { event: 'start', method: 'Light.disable' });
    object.addComponent(EventTrigger, { event: 'start', method: 'GameObject.deactivate', delay: 0.05 });
    scene.add(object);
    let held = 0;
    scene.pause = () => held++;
    simulation.play();
    for (let i = 0; i < 3; i++) simulation.advance(0.1);
    expect([light.enabled, object.active, held]).toEqual([false, false, 0]);
    simulation.pause();
    expect(held).toBe(1);
    simulation.step();
    expect(held).toBe(2);
    simulation.stop();
    expect([light.enabled, object.active]).toEqual([true, true]);
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

  it('groups in the middle of the objects below a parent that is moved, turned and sized too', () => {
    const { commands, scene } = new EditorDocument();
    const parent = new GameObject('Parent');
    Object.assign(parent.transform, { position: [5, -2, 1], rotation: [0.3, 1, -0.2], scale: [2, 2, 2] });
    const objects = [0, 1, 2].map((i) => {
      const object = new GameObject(`Object ${i}`);
      object.transform.position = [i * i, 1, -i];
      parent.add(object);
      return object;
    });
    scene.add(parent);
    const worlds = objects.map(({ transform }) => transform.worldPosition);
    commands.run(groupObjects(scene, objects));
    const [group] = parent.children;
    expect(group.children).toEqual(objects);
    const middle = new Vector3();
    for (const world of worlds) middle.addScaledVector(world, 1 / worlds.length);
    expect(group.transform.worldPosition.distanceTo(middle)).toBeLessThan(1e-9);
    for (const [i, { transform }] of objects.entries())
      expect(transform.worldPosition.distanceTo(worlds[i])).toBeLessThan(1e-9);
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
    const text = copyObjects(scene, [source]).text;
    commands.run(pasteObjects(scene, text, parent, []));
    const [copy] = parent.children;
    expect(copy.id).not.toBe(source.id);
    expect(copy.children.map(({ name }) => name)).toEqual(['Child']);
    copy.transform.worldPosition.toArray().forEach((value, i) => expect(value).toBeCloseTo([1, 2, 3][i], 9));
    expect(() => pasteObjects(scene, text.replace('"Transform"', '"Teleporter"'), scene, [])).toThrow(/Teleporter/);
    expect(() => pasteObjects(scene, 'text', scene, [])).toThrow(/clipboard/);
    expect(commands.history).toEqual(['Pasted Source']);
  });
});
