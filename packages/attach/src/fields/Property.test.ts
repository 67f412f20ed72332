import { FieldGesture, withCoordinate } from '@farol/editing';
import { Camera, Object3D, PerspectiveCamera, Scene, type WebGLRenderer } from 'three';
import { expect, it } from 'vitest';
import { Session } from '../model/Session';
import { sectionsOf } from './sectionsOf';

const makeSession = () => new Session(new Scene(), new Camera(), {} as WebGLRenderer);

it('edits objects of three by the gestures of the editing kernel', () => {
  const { commands } = makeSession();
  const objects = [1, 2].map((x) => {
    const object = new Object3D();
    object.rotation.set(x, x / 3, 0.123456789);
    return object;
  });
  const gesture = new FieldGesture(commands, sectionsOf(objects)[0].owners, 'rotation');
  gesture.preview(withCoordinate(1, 5));
  gesture.preview(withCoordinate(1, 7));
  const rotations = () => objects.map(({ rotation }) => rotation.toArray().slice(0, 3));
  expect(rotations()).toEqual([
    [1, 7, 0.123456789],
    [2, 7, 0.123456789],
  ]);
  gesture.commit();
  expect(commands.history).toEqual(['Set rotation of Object3D']);
  commands.undo();
  expect(rotations()).toEqual([
    [1, 1 / 3, 0.123456789],
    [2, 2 / 3, 0.123456789],
  ]);
  commands.redo();
  expect(rotations().map(([, y]) => y)).toEqual([7, 7]);
});

it('refuses what a field does not allow, and puts back what the page has that is not allowed', () => {
  const { commands } = makeSession();
  const camera = new PerspectiveCamera(50, 1, 0.1, Infinity);
  const { owners } = sectionsOf([camera])[2];
  const gesture = new FieldGesture(commands, owners, 'far');
  expect(() => gesture.preview(-1)).toThrow(/at least 0 m/);
  expect(camera.far).toBe(Infinity);
  gesture.commit(10);
  expect(camera.far).toBe(10);
  commands.undo();
  expect(camera.far).toBe(Infinity);
});
