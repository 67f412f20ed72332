import { asset, FieldError } from '@farol/editing/fields';
import { expect, test } from 'vitest';
import { component } from './Component';
import { GameObject } from './GameObject';
import { Scene } from './Scene';

/** A component without checks of its own. */
class Sign extends component({
  board: asset('mesh', 'box', { help: 'Shape of the board.' }),
  picture: asset('texture', null, { help: 'Picture on the board.' }),
}) {
  static override readonly typeName: string = 'Sign';
}

test('a field that names an asset takes the names that the library of the scene knows, and null', () => {
  const scene = new Scene();
  const object = new GameObject();
  scene.add(object);
  const sign = object.addComponent(Sign, { board: 'sphere' });
  expect(() => (sign.board = 'teapot')).toThrow(FieldError);
  expect(() => (sign.board = 'teapot')).toThrow(/^Sign.board names the mesh 'teapot', which is unknown \(known: box/);
  expect(() => (sign.picture = 'box')).toThrow(/names 'box', which is a mesh: a texture is needed/);
  expect([sign.board, sign.picture]).toEqual(['sphere', null]);
  sign.picture = 'stone';
  sign.board = null;
  expect([sign.board, sign.picture]).toEqual([null, 'stone']);
});

test('outside a scene any name goes, and is looked up when the object comes into one', () => {
  const sign = new Sign();
  sign.board = 'teapot';
  const object = new GameObject();
  object.addComponent(sign);
  const scene = new Scene();
  expect(() => scene.add(object)).toThrow(/^Sign.board names the mesh 'teapot'/);
  expect(scene.roots).toEqual([]);
});

test('so do the settings of a scene', () => {
  const { settings } = new Scene();
  expect(() => (settings.environment = 'box')).toThrow(/^Scene.environment names 'box', which is a mesh/);
});
