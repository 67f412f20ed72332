import { Matrix4, Object3D, Quaternion, Vector3 } from 'three';
import { expect, it } from 'vitest';
import { CommandStack } from '@farol/editing';
import { poseOf, SetPoses } from './SetPoses';

it('is one step of history for a drag of many previews, and puts everything back', () => {
  const objects = [new Object3D(), new Object3D()];
  const commands = new CommandStack<Object3D>();
  const gesture = commands.begin();
  const turned = new Quaternion(0, 1, 0, 0);
  gesture.preview(new SetPoses('Rotate', objects, [{ position: new Vector3(9, 9, 9), quaternion: turned }, {}]));
  for (const x of [1, 2])
    gesture.preview(new SetPoses('Move', objects, [{ position: new Vector3(x) }, { scale: new Vector3(x, 1, 1) }]));
  gesture.commit();
  const state = () => objects.map(({ position, scale, quaternion }) => [position.x, scale.x, quaternion.y]);
  const [before, after] = [
    [
      [0, 1, 0],
      [0, 1, 0],
    ],
    [
      [2, 1, 0],
      [0, 2, 0],
    ],
  ];
  expect([state(), commands.history]).toEqual([after, ['Move']]);
  commands.undo();
  expect(state()).toEqual(before);
  commands.redo();
  expect(state()).toEqual(after);
});

it('is no step where nothing is elsewhere', () => {
  const objects = [new Object3D()];
  const commands = new CommandStack<Object3D>();
  const gesture = commands.begin();
  for (const x of [3, 0]) gesture.preview(new SetPoses('Move', objects, [{ position: new Vector3(x, 0, 0) }]));
  gesture.commit();
  expect(commands.history).toEqual([]);
});

it('goes by the matrix of an object whose page sets the matrix by hand', () => {
  const object = new Object3D();
  object.matrixAutoUpdate = false;
  object.matrix.copy(new Matrix4().makeTranslation(5, 0, 0));
  expect(poseOf(object).position.x).toBe(5);
  const commands = new CommandStack<Object3D>();
  commands.run(new SetPoses('Move', [object], [{ position: new Vector3(7, 0, 0) }]));
  expect(object.matrix.elements[12]).toBe(7);
  commands.undo();
  expect(object.matrix.elements[12]).toBe(5);
});

it('keeps the angles that the page has given, when it is undone', () => {
  const object = new Object3D();
  object.rotation.set(0, 2.9, 0);
  const commands = new CommandStack<Object3D>();
  const quaternion = new Quaternion(0, 0, 0, 1);
  commands.run(new SetPoses('Rotate', [object], [{ quaternion, angles: [2 * Math.PI, 0, 0] }]));
  expect(object.rotation.x).toBe(2 * Math.PI);
  commands.undo();
  expect(object.rotation.toArray().slice(0, 3)).toEqual([0, 2.9, 0]);
});
