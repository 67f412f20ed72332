import { FieldGesture } from '@farol/editing';
import { GameObject, Light } from '@farol/engine';
import type { Vector3Tuple } from '@farol/engine/fields';
import { expect, it } from 'vitest';
import { EditorDocument } from './EditorDocument';

function twoLights(): { document: EditorDocument; lights: Light[] } {
  const document = new EditorDocument();
  const lights = [1, 2].map((place) => {
    const object = new GameObject(`Light ${place}`);
    object.transform.position = [place, place, place];
    const light = object.addComponent(Light, { intensity: place });
    document.scene.add(object);
    return light;
  });
  return { document, lights };
}

it('edits several owners in one step, each from its own value', () => {
  const { document, lights } = twoLights();
  const transforms = lights.map(({ gameObject }) => gameObject.transform);
  const gesture = new FieldGesture(document.commands, transforms, 'position');
  for (const x of [5, 6, 7]) gesture.preview((before) => [x, ...(before as Vector3Tuple).slice(1)] as never);
  expect(document.commands.history).toEqual([]);
  gesture.commit();
  expect(transforms.map(({ position }) => position)).toEqual([
    [7, 1, 1],
    [7, 2, 2],
  ]);
  expect(document.commands.history).toEqual(['Set position of Transform']);
  document.commands.undo();
  expect(transforms.map(({ position }) => position)).toEqual([
    [1, 1, 1],
    [2, 2, 2],
  ]);
});

it('lets an undo in the middle of a drag stand', () => {
  const { document, lights } = twoLights();
  const gesture = new FieldGesture(document.commands, [lights[0]], 'intensity');
  gesture.preview(5);
  document.commands.undo();
  gesture.preview(8);
  gesture.commit();
  expect(lights[0].intensity).toBe(1);
  gesture.commit(9);
  expect(lights[0].intensity).toBe(9);
});

it('takes a value that comes after the commit into the same step, unless that was undone', () => {
  const { document, lights } = twoLights();
  const { commands } = document;
  const gesture = new FieldGesture(commands, lights, 'intensity');
  gesture.preview(5);
  gesture.commit();
  commands.markSaved();
  gesture.amend(6);
  gesture.amend(7);
  expect(commands.history).toEqual(['Set intensity of Light to 7']);
  expect(commands.isDirty).toBe(true);
  expect(lights.map(({ intensity }) => intensity)).toEqual([7, 7]);
  commands.undo();
  gesture.amend(8);
  expect(lights.map(({ intensity }) => intensity)).toEqual([1, 2]);
  commands.redo();
  expect(lights.map(({ intensity }) => intensity)).toEqual([7, 7]);

  // a press without a value: the step consists of the late value
  gesture.commit();
  gesture.amend(9);
  gesture.amend(10);
  expect(commands.history).toHaveLength(2);
  // the late value equals the one before the press: no step
  gesture.amend(7);
  expect(commands.history).toHaveLength(1);
  expect(() => gesture.amend(-1)).toThrow(/at least 0/);
  expect(lights.map(({ intensity }) => intensity)).toEqual([7, 7]);
});

it('refuses a wrong value and keeps the one before', () => {
  const { document, lights } = twoLights();
  const gesture = new FieldGesture(document.commands, [lights[1]], 'intensity');
  gesture.preview(3);
  expect(() => gesture.preview(-1)).toThrow(/at least 0/);
  gesture.commit();
  expect(lights[1].intensity).toBe(3);
});
