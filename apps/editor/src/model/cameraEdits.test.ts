import { CommandStack } from '@farol/editing';
import { Camera, createRandom, GameObject, Scene } from '@farol/engine';
import { Quaternion, Vector3 } from 'three';
import { expect, it } from 'vitest';
import { addCameraAt, alignCamera, type CameraView, poseProblem } from './cameraEdits';
import { isEvenlyScaled } from './isEvenlyScaled';

const random = createRandom(7);
const number = (): number => random() * 20 - 10;

function someView(size: number | null): CameraView {
  return {
    position: new Vector3(number(), number(), number()),
    quaternion: new Quaternion(number(), number(), number(), number()).normalize(),
    fov: 0.9,
    size,
    far: 340.5,
  };
}

/** A camera below two rotated, evenly scaled objects. */
function cameraBelow(scale: readonly [number, number, number] = [2, 2, 2]): { scene: Scene; camera: Camera } {
  const scene = new Scene();
  const [above, parent, object] = ['Above', 'Parent', 'Camera'].map((name) => new GameObject(name));
  for (const each of [above, parent, object]) {
    each.transform.position = [number(), number(), number()];
    each.transform.rotation = [number(), number(), number()];
  }
  above.transform.scale = scale;
  parent.transform.scale = [0.5, 0.5, 0.5];
  above.add(parent);
  parent.add(object);
  scene.add(above);
  return { scene, camera: object.addComponent(Camera) };
}

function expectSeenFrom(camera: Camera, { position, quaternion }: CameraView): void {
  camera.three.updateWorldMatrix(true, false);
  const place = new Vector3();
  const turn = new Quaternion();
  camera.three.matrixWorld.decompose(place, turn, new Vector3());
  expect(place.distanceTo(position)).toBeLessThan(1e-9);
  expect(turn.angleTo(quaternion)).toBeLessThan(1e-6);
}

it('brings a camera below turned and scaled objects to a view, as one step', () => {
  for (let i = 0; i < 20; i++) {
    const { camera } = cameraBelow();
    const commands = new CommandStack();
    const before = camera.gameObject.transform.authoredValues();
    const view = someView(null);
    commands.run(alignCamera(camera, view));
    expectSeenFrom(camera, view);
    expect(camera.fov, "a camera's own field of view stays").toBe(Math.PI / 3);
    expect(commands.history).toEqual(['Aligned Camera to the view']);
    commands.undo();
    expect(camera.gameObject.transform.authoredValues()).toEqual(before);
  }
});

it('takes over a view without perspective with its size, and one with perspective again', () => {
  const { camera } = cameraBelow();
  const commands = new CommandStack();
  commands.run(alignCamera(camera, someView(12)));
  expect([camera.projection, camera.size, camera.far]).toEqual(['orthographic', 12, 341]);
  commands.run(alignCamera(camera, someView(null)));
  expect([camera.projection, camera.fov]).toEqual(['perspective', 0.9]);
  commands.undo();
  commands.undo();
  expect([camera.projection, camera.size, camera.far]).toEqual(['perspective', 10, 200]);
});

it('says why a camera cannot be moved', () => {
  const { camera } = cameraBelow([1, 2, 1]);
  expect(poseProblem(camera)).toBe(
    'Camera is below Parent, which is scaled unevenly: scale it evenly to move the camera.',
  );
  expect(() => alignCamera(camera, someView(null))).toThrow('scaled unevenly');
  expect(isEvenlyScaled(cameraBelow([-1, 1, 1]).camera.gameObject.parent!), 'mirrored').toBe(false);
  const locked = cameraBelow().camera;
  expect(poseProblem(locked)).toBeNull();
  locked.gameObject.parent!.locked = true;
  expect(poseProblem(locked)).toBe('Camera is locked: unlock it to move it.');
});

it('adds a camera that sees the view, and takes it out again', () => {
  const { scene } = cameraBelow();
  const commands = new CommandStack();
  const view = someView(null);
  const before = scene.size;
  commands.run(addCameraAt(scene, 'Camera', view, []));
  const added = scene.roots.at(-1)!.getComponent(Camera)!;
  expectSeenFrom(added, view);
  expect(added.fov).toBe(0.9);
  commands.undo();
  expect(scene.size).toBe(before);
});
