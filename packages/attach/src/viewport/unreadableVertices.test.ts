import {
  BoxGeometry,
  type BufferGeometry,
  GLBufferAttribute,
  Group,
  Mesh,
  type Object3D,
  PerspectiveCamera,
  Scene,
  Sphere,
  Vector2,
  Vector3,
  type WebGLRenderer,
} from 'three';
import { expect, it, vi } from 'vitest';
import { Session } from '../model/Session';
import { pickObject } from './pickObject';
import { SelectionBox } from './SelectionBox';

/** Geometry whose arrays the page has freed after three's upload. */
function freed(geometry: BufferGeometry, empty: unknown): BufferGeometry {
  geometry.computeBoundingSphere();
  (geometry.attributes.position as { array: unknown }).array = empty;
  return geometry;
}

function onGPU(): BufferGeometry {
  const geometry = new BoxGeometry();
  geometry.setAttribute('position', new GLBufferAttribute({}, 5126, 3, 4, 24) as never);
  geometry.boundingSphere = new Sphere(new Vector3(), 1);
  return geometry;
}

const blind = () => [
  new Mesh(freed(new BoxGeometry(), null)),
  new Mesh(freed(new BoxGeometry(), new Float32Array(0))),
  new Mesh(onGPU()),
];

function sceneOf(...objects: Object3D[]): Scene {
  const scene = new Scene().add(...objects);
  scene.updateMatrixWorld();
  return scene;
}

it('clicks go through what has its vertices on the GPU alone, which is named once, and find what the page casts at itself', () => {
  const warn = vi.spyOn(console, 'warn').mockReturnValue();
  const error = vi.spyOn(console, 'error');
  const behind = new Mesh(new BoxGeometry(9, 9, 1));
  behind.position.z = -3;
  const meshes = blind();
  const scene = sceneOf(behind, ...meshes);
  const camera = new PerspectiveCamera();
  camera.position.z = 5;
  camera.updateMatrixWorld();
  const pick = () => pickObject(scene, camera, new Vector2());
  expect(pick()).toBe(behind);
  expect(pick()).toBe(behind);
  expect(warn.mock.calls.flat()).toEqual(
    meshes.map(({ uuid }) => expect.stringContaining(`clicks do not find Mesh "${uuid}", whose arrays were freed`)),
  );
  const [own] = meshes;
  own.raycast = (_raycaster, hits) => void hits.push({ distance: 1, point: new Vector3(), object: own });
  expect(pick()).toBe(own);
  expect(error).not.toHaveBeenCalled();
  vi.restoreAllMocks();
});

it('what is selected has a box of lines where its size is known', () => {
  const error = vi.spyOn(console, 'error');
  const [first, second, third] = blind();
  const plain = new Mesh(new BoxGeometry());
  const group = new Group().add(third);
  const told = new BoxGeometry();
  told.computeBoundingBox();
  const measured = new Mesh(freed(told, null));
  const session = new Session(
    sceneOf(first, second, group, plain, measured),
    new PerspectiveCamera(),
    {} as WebGLRenderer,
  );
  const overlay = new Scene();
  const boxes = new SelectionBox(session, overlay);
  session.selection.set([first, second, group, plain, measured]);
  boxes.update();
  expect(overlay.children.length).toBe(2);
  boxes.dispose();
  expect(error).not.toHaveBeenCalled();
  vi.restoreAllMocks();
});
