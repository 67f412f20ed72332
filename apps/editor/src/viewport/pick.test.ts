import { GameObject, Light, ObjectRenderer, Scene } from '@farol/engine';
import {
  Bone,
  BoxGeometry,
  BufferAttribute,
  MeshBasicMaterial,
  PerspectiveCamera,
  Skeleton,
  SkinnedMesh,
  Vector2,
  Vector3,
} from 'three';
import { expect, it } from 'vitest';
import { pick } from './pick';
import { pickBox } from './pickBox';

const camera = new PerspectiveCamera(50, 1, 0.1, 100);
camera.position.set(0, 0, 20);
camera.updateMatrixWorld();

/** Normalised device coordinates of a world point. */
function pointOf(x: number, y: number, z = 0): Vector2 {
  const place = new Vector3(x, y, z).project(camera);
  return new Vector2(place.x, place.y);
}

function box(scene: Scene, name: string, x: number, values = {}): GameObject {
  const object = new GameObject(name);
  object.addComponent(ObjectRenderer, { mesh: 'box', ...values });
  object.transform.position = [x, 0, 0];
  scene.add(object);
  return object;
}

it('finds each of many instances, and through what is locked', () => {
  const scene = new Scene();
  const boxes = [-3, 0, 3].map((x) => box(scene, `Box ${x}`, x, { instanced: true }));
  const front = box(scene, 'Front', 0);
  front.transform.position = [0, 0, 2];
  scene.three.updateMatrixWorld();
  for (const [i, x] of [-3, 3].entries()) expect(pick(scene, camera, pointOf(x, 0))?.object).toBe(boxes[i * 2]);
  expect(pick(scene, camera, pointOf(0, 0))?.object).toBe(front);
  front.locked = true;
  expect(pick(scene, camera, pointOf(0, 0))?.object).toBe(boxes[1]);
  expect(pick(scene, camera, pointOf(0, 5))).toBeNull();
  scene.dispose();
});

it('finds a skinned mesh where its bones have it, not where it was', () => {
  const scene = new Scene();
  const owner = new GameObject('Skinned');
  scene.add(owner);
  const geometry = new BoxGeometry();
  const count = geometry.attributes.position.count;
  geometry.setAttribute('skinIndex', new BufferAttribute(new Uint16Array(count * 4), 4));
  const weights = new Float32Array(count * 4);
  for (let i = 0; i < count; i++) weights[i * 4] = 1;
  geometry.setAttribute('skinWeight', new BufferAttribute(weights, 4));
  const bone = new Bone();
  const mesh = new SkinnedMesh(geometry, new MeshBasicMaterial());
  mesh.add(bone);
  mesh.bind(new Skeleton([bone]));
  owner.object3D.add(mesh);
  scene.three.updateMatrixWorld();
  expect(pick(scene, camera, pointOf(0, 0))?.object).toBe(owner);
  bone.position.set(5, 0, 0);
  scene.three.updateMatrixWorld();
  mesh.skeleton.update();
  expect(pick(scene, camera, pointOf(5, 0))?.object).toBe(owner);
  expect(pick(scene, camera, pointOf(0, 0))).toBeNull();
});

it('gives what has its middle in a box: meshes, instances and lights, none that is hidden or locked', () => {
  const scene = new Scene();
  const shown = [box(scene, 'A', -3), box(scene, 'B', -1, { instanced: true })];
  box(scene, 'Outside', 5);
  box(scene, 'Hidden', 0).active = false;
  box(scene, 'Locked', 0).locked = true;
  const lamp = new GameObject('Lamp');
  lamp.addComponent(Light);
  lamp.transform.position = [1, 1, 0];
  scene.add(lamp);
  const behind = box(scene, 'Behind', 0);
  behind.transform.position = [0, 0, 30];
  scene.three.updateMatrixWorld();
  const found = pickBox(scene, camera, [pointOf(-4, -2), pointOf(3, 2)]);
  expect(found).toEqual([...shown, lamp]);
  scene.dispose();
});
