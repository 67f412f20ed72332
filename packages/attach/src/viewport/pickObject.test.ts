import { BoxGeometry, Group, Mesh, OrthographicCamera, Scene, Vector2 } from 'three';
import { beforeEach, expect, it } from 'vitest';
import { pickObject } from './pickObject';

const camera = new OrthographicCamera(-1, 1, 1, -1, 0, 10);
camera.position.z = 5;
camera.updateMatrixWorld();

let scene: Scene;
/** A box at the left of the picture, and one behind it. */
let near: Mesh, far: Mesh;

function box(name: string, z: number): Mesh {
  const made = new Mesh(new BoxGeometry(0.5, 0.5, 0.5));
  made.name = name;
  made.position.set(-0.5, 0, z);
  return made;
}

beforeEach(() => {
  camera.layers.set(0);
  [near, far] = [box('near', 2), box('far', -2)];
  scene = new Scene().add(far, new Group().add(near));
});

const picked = (x: number): string | null => {
  scene.updateMatrixWorld();
  return pickObject(scene, camera, new Vector2(x, 0))?.name ?? null;
};

it('is the nearest object under the point, and nothing beside all of them', () => {
  expect([picked(-0.5), picked(0.5)]).toEqual(['near', null]);
});

it.each<[string, () => void]>([
  ['is hidden', () => (near.visible = false)],
  ['is below a hidden one', () => (near.parent!.visible = false)],
  ['is in no layer of the camera', () => near.layers.set(3)],
  ['has had its raycasting taken away', () => Object.assign(near, { raycast: null })],
])('passes by an object that %s', (_, change) => {
  change();
  expect(picked(-0.5)).toBe('far');
});

it('is an object of any layer that the camera sees', () => {
  near.layers.set(3);
  camera.layers.enable(3);
  expect(picked(-0.5)).toBe('near');
  camera.layers.set(3);
  expect(picked(-0.5)).toBe('near');
  near.visible = false;
  expect(picked(-0.5)).toBe(null);
});
