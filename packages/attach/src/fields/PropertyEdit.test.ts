import { Camera, Object3D, Scene, type WebGLRenderer } from 'three';
import { expect, it } from 'vitest';
import { Session } from '../model/Session';
import { PropertyEdit } from './PropertyEdit';
import { sectionsOf } from './sectionsOf';

const makeSession = () => new Session(new Scene(), new Camera(), {} as WebGLRenderer);

it('edits one component of several vectors, and leaves the others as each has them', () => {
  const session = makeSession();
  const objects = [1, 2].map((x) => {
    const object = new Object3D();
    object.position.set(x, 10 * x, 100 * x);
    return object;
  });
  const position = sectionsOf(objects)[0].properties[0];
  const edit = new PropertyEdit(session, position);
  edit.preview([null, 5, null]);
  edit.preview([null, 7, null]);
  expect(position.get()).toEqual([
    [1, 7, 100],
    [2, 7, 200],
  ]);
  edit.commit();
  session.history.undo();
  expect(position.get()).toEqual([
    [1, 10, 100],
    [2, 20, 200],
  ]);
  session.history.redo();
  expect(objects.map(({ position: { y } }) => y)).toEqual([7, 7]);
  expect(session.history.undoLabel).toBe('change of position');
});

it('keeps nothing when all values are what they were, and goes back when discarded', () => {
  const session = makeSession();
  const objects = [new Object3D(), new Object3D()];
  const visible = sectionsOf(objects)[1].properties.find(({ name }) => name === 'visible')!;
  const same = new PropertyEdit(session, visible);
  same.preview(true);
  same.commit();
  expect(session.history.undoLabel).toBe(null);
  objects[1].visible = false;
  const other = new PropertyEdit(session, visible);
  other.preview(true);
  expect(visible.get()).toEqual([true, true]);
  other.discard();
  expect(visible.get()).toEqual([true, false]);
  expect(other.problemWith('yes')).not.toBe(null);
});
