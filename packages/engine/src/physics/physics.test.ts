import { BoxGeometry } from 'three';
import { expect, test } from 'vitest';
import { Collider } from '../components/Collider';
import { ObjectRenderer } from '../components/ObjectRenderer';
import { RigidBody } from '../components/RigidBody';
import { Component } from '../core/Component';
import { createRandom } from '../base/createRandom';
import { GameObject } from '../core/GameObject';
import type { Scene } from '../core/Scene';
import { serialize } from '../files/serialize';
import { PhysicsSystem } from './PhysicsSystem';
import { box, ground, makeScene, placesOf, prepare, run, worldOf } from '../components/testing/physicsScene';

/** Distance of a fall after a number of steps (m): Rapier splits each step in four, with the velocity first. */
const fallen = (steps: number): number => (9.81 / 2) * (steps / 60) * (steps / 60 + 1 / 240);

test('a body falls as gravity says, and rests on what is fixed', async () => {
  const scene = makeScene();
  const cube = box('Cube', [0, 10, 0]);
  scene.add(ground()).add(cube);
  await prepare(scene);
  run(scene, 60);
  expect(worldOf(cube).y).toBeCloseTo(10 - fallen(59), 3);
  run(scene, 300);
  expect(worldOf(cube).y).toBeCloseTo(0.5, 2);
  expect(cube.getComponent(RigidBody)!.isSleeping).toBe(true);
  scene.settings.gravity = [0, 3, 0];
  cube.getComponent(RigidBody)!.wakeUp();
  run(scene, 60);
  expect(worldOf(cube).y).toBeGreaterThan(1.5);
});

test('what is played is simulation: no edit, not saved, and taken back bit by bit', async () => {
  const scene = makeScene();
  const random = createRandom(7);
  scene.add(ground());
  for (let i = 0; i < 20; i++) {
    const cube = box(`Cube ${i}`, [random() * 3, 1 + i, random() * 3]);
    cube.transform.rotation = [random(), random(), random()];
    scene.add(cube);
  }
  const file = JSON.stringify(serialize(scene));
  const places = placesOf(scene);
  await prepare(scene);
  const { revision } = scene;
  run(scene, 200);
  const played = placesOf(scene);
  expect(played).not.toEqual(places);
  expect(JSON.stringify(serialize(scene))).toBe(file);
  expect(scene.revision).toBe(revision);
  scene.reset();
  expect(placesOf(scene)).toEqual(places);
  expect(scene.system(PhysicsSystem).steps).toBe(0);
  run(scene, 200);
  expect(placesOf(scene)).toEqual(played);
});

/** A heap of boxes, spheres and capsules under parents. */
async function heap(): Promise<Scene> {
  const scene = makeScene();
  const random = createRandom(3);
  scene.add(ground());
  const shapes = ['box', 'sphere', 'capsule', 'cylinder', 'hull'];
  const parent = new GameObject('Parent');
  parent.transform.position = [1, 2, 3];
  parent.transform.rotation = [0.2, 0.4, 0];
  scene.add(parent);
  for (let i = 0; i < 60; i++) {
    const object = box(`Thing ${i}`, [random() * 2, 2 + i * 0.6, random() * 2], {}, { shape: shapes[i % 5] });
    if (i % 3 === 0) parent.add(object);
    else scene.add(object);
  }
  await prepare(scene);
  return scene;
}

test('600 steps put everything to the same bits, run after run', async () => {
  const [first, second] = [await heap(), await heap()];
  run(first, 600);
  run(second, 600);
  expect(first.system(PhysicsSystem).steps).toBe(600);
  expect(placesOf(second)).toEqual(placesOf(first));
});

test('frames of any length take whole steps; the picture lies between the last two', async () => {
  const scene = makeScene();
  const cube = box('Cube', [0, 100, 0]);
  scene.add(cube);
  await prepare(scene);
  const system = scene.system(PhysicsSystem);
  scene.update(1 / 60);
  const first = worldOf(cube).y;
  scene.update(1 / 120);
  expect(system.steps).toBe(1);
  scene.update(1 / 120);
  expect(system.steps).toBe(2);
  scene.update(1 / 120);
  const halfway = worldOf(cube).y;
  scene.update(1 / 120);
  expect(system.steps).toBe(3);
  expect(halfway).toBeLessThan(first);
  expect(halfway).toBeGreaterThan(worldOf(cube).y);
  scene.update(0.1);
  expect(system.steps).toBe(9);
  // time beyond the longest frame is dropped
  scene.update(5);
  expect(system.steps).toBe(15);
  scene.setTime(3);
  expect(system.steps).toBe(15);
});

test('under parents that are moved, rotated and scaled a body falls straight down in the world', async () => {
  const scene = makeScene();
  const outer = new GameObject('Outer');
  outer.transform.position = [5, 0, 0];
  outer.transform.rotation = [0.3, 1, -0.4];
  outer.transform.scale = [2, 2, 2];
  const mirror = new GameObject('Mirror');
  mirror.transform.scale = [-1, 1, 1];
  mirror.transform.rotation = [0, 0.5, 0];
  const cube = box('Cube', [0, 4, 1]);
  outer.add(mirror);
  mirror.add(cube);
  scene.add(ground()).add(outer);
  const before = worldOf(cube);
  const turnBefore = cube.object3D.quaternion.clone();
  await prepare(scene);
  run(scene, 30);
  const after = worldOf(cube);
  expect(after.x).toBeCloseTo(before.x, 4);
  expect(after.z).toBeCloseTo(before.z, 4);
  expect(after.y).toBeCloseTo(before.y - fallen(29), 3);
  expect(cube.object3D.quaternion.angleTo(turnBefore)).toBeLessThan(1e-4);
  run(scene, 600);
  // 2 m in size, it comes to rest on one of its faces
  expect(worldOf(cube).y).toBeCloseTo(1, 1);
});

test('colliders are fitted to the mesh, whatever its size, and follow the scale', async () => {
  const scene = makeScene();
  scene.assets.register('slab', new BoxGeometry(4, 0.2, 4).translate(0, 1, 0));
  const slab = box('Slab', [0, 0, 0], null);
  slab.getComponent(ObjectRenderer)!.mesh = 'slab';
  slab.transform.scale = [1, 2, 1];
  const model = new GameObject('Whole');
  model.transform.position = [0, 6, 0];
  // an object without a mesh gets the size of its descendants
  const part = new GameObject('Part');
  part.addComponent(ObjectRenderer, { mesh: 'box' });
  part.transform.position = [0, 0.5, 0];
  model.add(part);
  model.addComponent(RigidBody);
  model.addComponent(Collider);
  scene.add(slab).add(model);
  await prepare(scene);
  run(scene, 300);
  // top of the slab: (1 + 0.1) * 2
  expect(worldOf(model).y).toBeCloseTo(2.2, 2);
});

test('a kinematic body goes where its object is moved, and pushes; a dynamic one that is moved by hand goes on from there', async () => {
  const scene = makeScene();
  class Mover extends Component {
    static override readonly typeName = 'Mover';
    override update(deltaSeconds: number): void {
      this.gameObject.object3D.position.x += deltaSeconds;
    }
  }
  const pusher = box('Pusher', [-2, 0.5, 0], { type: 'kinematic' });
  pusher.addComponent(Mover);
  const cube = box('Cube', [0, 0.5, 0]);
  const lone = box('Lone', [20, 0.5, 20]);
  scene.add(ground()).add(pusher).add(cube).add(lone);
  await prepare(scene);
  run(scene, 180);
  expect(worldOf(pusher).x).toBeCloseTo(1, 5);
  expect(worldOf(cube).x).toBeCloseTo(2, 1);
  lone.object3D.position.y = 8;
  run(scene, 1);
  expect(worldOf(lone).y).toBeCloseTo(8, 1);
  run(scene, 20);
  expect(worldOf(lone).y).toBeLessThan(7.5);
});

test('colliders of one object and of those below it make one body', async () => {
  const scene = makeScene();
  const table = new GameObject('Table');
  table.transform.position = [0, 2, 0];
  table.addComponent(RigidBody, { mass: 10 });
  table.addComponent(Collider, { fit: false, size: [2, 0.1, 2] });
  for (const x of [-0.9, 0.9]) {
    const leg = new GameObject('Leg');
    leg.transform.position = [x, -0.5, 0];
    leg.addComponent(Collider, { fit: false, size: [0.1, 1, 1.8] });
    table.add(leg);
  }
  scene.add(ground()).add(table);
  await prepare(scene);
  run(scene, 300);
  expect(worldOf(table).y).toBeCloseTo(1, 2);
  const { control } = table.getComponent(RigidBody) as unknown as { control: { mass: number } };
  expect(control.mass).toBeCloseTo(10, 4);
});

test('objects come, go, sleep and change while the scene plays', async () => {
  const scene = makeScene();
  const floor = ground();
  const first = box('First', [0, 3, 0]);
  scene.add(floor).add(first);
  await prepare(scene);
  run(scene, 200);
  const second = box('Second', [0, 3, 0]);
  scene.add(second);
  run(scene, 200);
  expect(worldOf(second).y).toBeCloseTo(1.5, 1);
  scene.remove(first);
  run(scene, 200);
  expect(worldOf(second).y).toBeCloseTo(0.5, 1);
  floor.active = false;
  run(scene, 30);
  expect(worldOf(second).y).toBeLessThan(0);
  const { y } = worldOf(second);
  second.getComponent(RigidBody)!.type = 'fixed';
  run(scene, 30);
  expect(worldOf(second).y).toBeCloseTo(y, 1);
});

test.each([
  [
    'no mesh',
    (object: GameObject) => object.removeComponent(object.getComponent(ObjectRenderer)!),
    /'Odd' has no mesh to fit to/,
  ],
  [
    'a mesh on a dynamic body',
    (object: GameObject) => (object.getComponent(Collider)!.shape = 'mesh'),
    /'Odd' is a mesh on a dynamic body: choose the convex hull/,
  ],
  ['a scale of 0', (object: GameObject) => (object.transform.scale = [1, 0, 1]), /'Odd' has no size/],
])('a collider with %s is told once, and the rest goes on', async (_, spoil, message) => {
  const scene = makeScene();
  const errors: string[] = [];
  scene.onComponentError = (component, error) => errors.push(`${component.typeName}: ${(error as Error).message}`);
  const odd = box('Odd', [0, 5, 0]);
  spoil(odd);
  const cube = box('Cube', [3, 5, 0]);
  scene.add(ground()).add(odd).add(cube);
  await prepare(scene);
  run(scene, 200);
  expect(errors).toHaveLength(1);
  expect(errors[0]).toMatch(message);
  expect(worldOf(cube).y).toBeCloseTo(0.5, 1);
});

test('a scene that plays before Rapier and its meshes are there begins with step 0 once they are', async () => {
  const cubeOver = (scene: Scene): GameObject => {
    const cube = box('Cube', [0, 3, 0]);
    scene.add(ground()).add(cube);
    return cube;
  };
  const late = makeScene();
  const cube = cubeOver(late);
  expect(late.system(PhysicsSystem).ready).toBe(false);
  run(late, 5);
  expect(worldOf(cube).y).toBe(3);
  await prepare(late);
  const inTime = makeScene();
  cubeOver(inTime);
  await prepare(inTime);
  run(late, 100);
  run(inTime, 100);
  expect(late.system(PhysicsSystem).steps).toBe(100);
  expect(placesOf(late)).toEqual(placesOf(inTime));
});

test('a collider below a body that moves in it stays the same one: what lies on it goes on touching it', async () => {
  const scene = makeScene();
  const body = new GameObject('Lift');
  body.addComponent(RigidBody, { type: 'kinematic' });
  const arm = box('Arm', [0, 0, 0], null);
  arm.transform.scale = [3, 1, 3];
  arm.transform.rotation = [0, 0.3, 0];
  body.add(arm);
  scene.add(body);
  const load = box('Load', [0, 1.05, 0]);
  const heard: string[] = [];
  class Hears extends Component {
    static override readonly typeName = 'Hears';
    onCollisionEnter(): void {
      heard.push('enter');
    }
    onCollisionExit(): void {
      heard.push('exit');
    }
  }
  load.addComponent(new Hears());
  scene.add(load);
  await prepare(scene);
  run(scene, 40);
  expect(heard).toEqual(['enter']);
  for (let i = 0; i < 60; i++) {
    arm.object3D.position.y += 0.005;
    arm.object3D.rotation.y += 0.01;
    run(scene, 1);
  }
  expect(heard, 'while it was moved and turned').toEqual(['enter']);
  run(scene, 60);
  expect(worldOf(load).y).toBeGreaterThan(1.28);
  expect(worldOf(load).y).toBeLessThan(1.32);
  // another size needs a new shape
  arm.object3D.scale.y = 2;
  run(scene, 60);
  expect(worldOf(load).y).toBeGreaterThan(1.75);
  expect(heard.length % 2).toBe(1);
});
