import { afterEach, expect, test, vi } from 'vitest';
import { Camera } from '../components/Camera';
import { CharacterController } from '../components/CharacterController';
import { RigidBody } from '../components/RigidBody';
import { Component } from '../core/Component';
import type { EnginePointerEvent } from '../core/events';
import { GameObject } from '../core/GameObject';
import type { Scene } from '../core/Scene';
import type { CollisionEvent } from './CollisionEvent';
import {
  box,
  ground,
  makeScene,
  placesOf,
  prepare,
  run,
  type Values,
  worldOf,
} from '../components/testing/physicsScene';

function walker(values: Values = {}): { scene: Scene; person: GameObject; controller: CharacterController } {
  const scene = makeScene();
  const person = new GameObject('Person', { id: 'Person' });
  person.transform.position = [0, 0.2, 0];
  const controller = person.addComponent(CharacterController, values);
  const head = new GameObject('Head');
  head.transform.position = [0, 1.6, 0];
  head.addComponent(Camera);
  person.add(head);
  scene.add(ground()).add(person);
  return { scene, person, controller };
}

function key(scene: Scene, type: 'down' | 'up', code: string): void {
  scene.dispatchKey({
    type,
    code,
    key: '',
    repeat: false,
    shiftKey: false,
    ctrlKey: false,
    altKey: false,
    metaKey: false,
  });
}

const pointer = (values: Partial<EnginePointerEvent>): EnginePointerEvent => ({
  ...{ type: 'move', x: 0, y: 0, dx: 0, dy: 0, ndcX: 0, ndcY: 0, button: 0, buttons: 1, pointerId: 1, wheel: 0 },
  ...{ shiftKey: false, ctrlKey: false, altKey: false, metaKey: false },
  ...values,
});

afterEach(() => void vi.unstubAllGlobals());

/** A gamepad in the form of browsers, with the given axes. @param pressed - indices of pressed buttons */
const pad = (axes: readonly number[], pressed: readonly number[] = [], mapping = 'standard'): object => ({
  ...{ connected: true, mapping, axes },
  buttons: Array.from({ length: 17 }, (_, i) => ({ pressed: pressed.includes(i) })),
});

test('it stands, walks by keys where it looks, runs, and takes keys from the editor', async () => {
  const { scene, person, controller } = walker();
  expect(scene.takesKeys).toBe(true);
  await prepare(scene);
  run(scene, 60);
  expect(controller.isGrounded).toBe(true);
  expect(worldOf(person).y).toBeCloseTo(0.01, 2);
  key(scene, 'down', 'KeyW');
  run(scene, 60);
  // 3 m/s, minus the loss during acceleration
  expect(worldOf(person).z).toBeLessThan(-2.6);
  expect(worldOf(person).z).toBeGreaterThan(-3.1);
  key(scene, 'up', 'KeyW');
  run(scene, 30);
  const { z } = worldOf(person);
  // a quarter turn to the right
  scene.dispatchPointer(pointer({ dx: Math.PI / 2 / 0.004 }));
  key(scene, 'down', 'ArrowUp');
  key(scene, 'down', 'ShiftLeft');
  run(scene, 60);
  expect(worldOf(person).x).toBeGreaterThan(5);
  expect(worldOf(person).z).toBeCloseTo(z, 1);
});

test('it jumps as high as it says, once, and only from the ground', async () => {
  const { scene, person } = walker({ jumpHeight: 1.5 });
  await prepare(scene);
  run(scene, 30);
  key(scene, 'down', 'Space');
  let highest = 0;
  for (let i = 0; i < 120; i++) {
    run(scene, 1);
    highest = Math.max(highest, worldOf(person).y);
    if (i === 30) {
      key(scene, 'up', 'Space');
      key(scene, 'down', 'Space');
    }
  }
  expect(highest).toBeGreaterThan(1.4);
  expect(highest).toBeLessThan(1.55);
  expect(worldOf(person).y).toBeCloseTo(0.01, 1);
});

test('it climbs steps and slopes, but no walls and no steep slopes', async () => {
  const { scene, person, controller } = walker();
  for (let i = 0; i < 4; i++) {
    const step = box(`Step ${i}`, [0, 0.1 + i * 0.2, -2 - i * 0.6], null);
    step.transform.scale = [2, 0.2 + i * 0.4, 0.6];
    step.transform.position = [0, (0.2 + i * 0.2) / 2, -2 - i * 0.6];
    step.transform.scale = [2, 0.2 + i * 0.2, 0.6];
    scene.add(step);
  }
  const wall = box('Wall', [0, 2, -6], null);
  wall.transform.scale = [10, 4, 1];
  scene.add(wall);
  await prepare(scene);
  run(scene, 20);
  controller.walk([0, 0, -1]);
  run(scene, 75);
  expect(worldOf(person).y).toBeGreaterThan(0.55);
  run(scene, 200);
  // down from the last step, and stopped by the wall
  expect(worldOf(person).y).toBeCloseTo(0.01, 1);
  expect(worldOf(person).z).toBeGreaterThan(-5.3);
  for (const [angle, isClimbed] of [
    [0.5, true],
    [1.1, false],
  ] as const) {
    const other = walker();
    const ramp = box('Ramp', [0, 0, -4], null);
    ramp.transform.scale = [4, 0.2, 6];
    ramp.transform.rotation = [angle, 0, 0];
    ramp.transform.position = [0, Math.sin(angle) * 3 - 0.1, -1.5 - Math.cos(angle) * 3];
    other.scene.add(ramp);
    await prepare(other.scene);
    other.controller.walk([0, 0, -1]);
    run(other.scene, 100);
    expect(worldOf(other.person).y > 0.8, `slope of ${angle}`).toBe(isClimbed);
  }
});

test('fingers: the left half is a stick, the right half looks, a tap there jumps', async () => {
  const { scene, person } = walker();
  await prepare(scene);
  run(scene, 30);
  const touch = { pointerType: 'touch' as const };
  scene.dispatchPointer(pointer({ ...touch, type: 'down', ndcX: -0.5, x: 50, y: 50, pointerId: 1 }));
  scene.dispatchPointer(pointer({ ...touch, type: 'move', ndcX: -0.5, x: 110, y: 50, dx: 60, pointerId: 1 }));
  run(scene, 60);
  expect(worldOf(person).x).toBeGreaterThan(2.5);
  scene.dispatchPointer(pointer({ ...touch, type: 'up', pointerId: 1 }));
  run(scene, 60);
  const turnBefore = person.object3D.quaternion.clone();
  scene.dispatchPointer(pointer({ ...touch, type: 'down', ndcX: 0.5, x: 300, y: 50, pointerId: 2 }));
  scene.dispatchPointer(pointer({ ...touch, type: 'move', ndcX: 0.5, x: 400, y: 90, dx: 100, dy: 40, pointerId: 2 }));
  scene.dispatchPointer(pointer({ ...touch, type: 'up', ndcX: 0.5, pointerId: 2 }));
  expect(person.object3D.quaternion.angleTo(turnBefore)).toBeCloseTo(0.4, 5);
  expect(scene.find('Head')!.object3D.rotation.x).toBeCloseTo(-0.16, 5);
  run(scene, 30);
  expect(worldOf(person).y).toBeCloseTo(0.01, 1);
  scene.dispatchPointer(pointer({ ...touch, type: 'down', ndcX: 0.5, pointerId: 3 }));
  scene.dispatchPointer(pointer({ ...touch, type: 'up', ndcX: 0.5, pointerId: 3 }));
  run(scene, 15);
  expect(worldOf(person).y).toBeGreaterThan(0.4);
});

test('a gamepad: the left stick walks, the right one looks, buttons run and jump; others and frames without any do nothing', async () => {
  let pads: (object | null)[] = [];
  vi.stubGlobal('navigator', { getGamepads: () => pads });
  const { scene, person, controller } = walker();
  await prepare(scene);
  run(scene, 60);
  /** Distance of the feet (m) walked from standing, with these gamepads. */
  const walked = (held: (object | null)[]): number[] => {
    pads = [];
    run(scene, 30);
    const before = worldOf(person);
    pads = held;
    run(scene, 60);
    const { x, z } = worldOf(person).sub(before);
    return [Math.round(x * 10) / 10, Math.round(z * 10) / 10];
  };
  const [side, ahead] = walked([null, pad([0, -1, 0, 0])]);
  expect(side).toBeCloseTo(0);
  expect(ahead).toBeLessThan(-2.6);
  const [, running] = walked([pad([0, -1, 0, 0], [10])]);
  expect(running).toBeLessThan(ahead * 1.3);
  expect(walked([pad([0.1, 0.1, 0, 0])])).toEqual([0, 0].map(() => expect.closeTo(0)));
  expect(walked([pad([0, -1, 0, 0], [], '')])).toEqual([0, 0].map(() => expect.closeTo(0)));
  // one second of turning right at 2.5 rad/s
  const turned = person.object3D.quaternion.clone();
  walked([pad([0, 0, 1, 0])]);
  expect(person.object3D.quaternion.angleTo(turned)).toBeCloseTo(2.5, 1);
  // the button is held: it jumps once
  pads = [pad([0, 0, 0, 0], [0])];
  let jumps = 0;
  let wasGrounded = true;
  for (let i = 0; i < 120; i++) {
    run(scene, 1);
    if (wasGrounded && !controller.isGrounded) jumps++;
    wasGrounded = controller.isGrounded;
  }
  expect(jumps).toBe(1);
  vi.stubGlobal('navigator', {
    getGamepads: () => {
      throw new Error('Access to the feature "gamepad" is disallowed by permissions policy.');
    },
  });
  const told: unknown[] = [];
  scene.onComponentError = (_component, error) => told.push(error);
  key(scene, 'down', 'KeyW');
  const before = worldOf(person);
  run(scene, 60);
  expect(told).toEqual([]);
  expect(worldOf(person).distanceTo(before)).toBeGreaterThan(2);
});

test('it is carried by what moves under it, pushes bodies, is heard by sensors and colliders, and is put back exactly', async () => {
  const { scene, person, controller } = walker();
  const heard: string[] = [];
  class Listener extends Component {
    static override readonly typeName = 'Listener';
    onCollisionEnter({ other }: CollisionEvent): void {
      heard.push(`${this.gameObject.name} touched by ${other.name}`);
    }
    onTriggerEnter({ other }: CollisionEvent): void {
      heard.push(`${this.gameObject.name} entered by ${other.name}`);
    }
  }
  class Mover extends Component {
    static override readonly typeName = 'Mover';
    override update(deltaSeconds: number): void {
      this.gameObject.object3D.position.x += deltaSeconds;
    }
  }
  person.transform.position = [0, 0.6, 0];
  const raft = box('Raft', [0, 0.25, 0], { type: 'kinematic' });
  raft.transform.scale = [3, 0.5, 3];
  raft.addComponent(Mover);
  const gate = box('Gate', [0, 1, -4], null, { sensor: true });
  gate.transform.scale = [20, 2, 0.2];
  const crate = box('Crate', [0, 0.5, -6], { mass: 5 });
  crate.transform.scale = [30, 1, 1];
  for (const each of [gate, crate]) each.addComponent(Listener);
  scene.add(raft).add(gate).add(crate);
  const places = placesOf(scene);
  await prepare(scene);
  run(scene, 120);
  expect(worldOf(person).x).toBeCloseTo(2, 0);
  expect(heard.splice(0)).toEqual(['Crate touched by Ground']);
  controller.walk([0, 0, -1]);
  run(scene, 240);
  expect(heard).toEqual(['Gate entered by Person', 'Crate touched by Person']);
  expect(worldOf(crate).z).toBeLessThan(-6.3);
  const played = placesOf(scene);
  scene.reset();
  expect(placesOf(scene)).toEqual(places);
  expect(controller.isGrounded).toBe(false);
  run(scene, 120);
  controller.walk([0, 0, -1]);
  run(scene, 240);
  expect(placesOf(scene)).toEqual(played);
});

test('a RigidBody beside it is told once', async () => {
  const { scene, person } = walker();
  const errors: string[] = [];
  scene.onComponentError = (_, error) => errors.push((error as Error).message);
  person.addComponent(RigidBody);
  await prepare(scene);
  run(scene, 60);
  expect(errors).toEqual([expect.stringMatching(/'Person' has a CharacterController.*remove the RigidBody/)]);
  expect(worldOf(person).y).toBeCloseTo(0.01, 1);
});

test('normals of a contact point to whom they are told, also of a character that comes while the scene plays', async () => {
  for (const isLate of [false, true]) {
    const { scene, person } = walker();
    const told: Record<string, number[]> = {};
    class Hearer extends Component {
      static override readonly typeName = 'Hearer';
      onCollisionEnter({ other, normal }: CollisionEvent): void {
        if (other.name === 'Ground') return;
        told[this.gameObject.name] = normal!.toArray().map((each) => Math.round(each) + 0);
      }
    }
    const wall = box('Wall', [0, 1, -2], null);
    wall.transform.scale = [4, 2, 1];
    for (const each of [person, wall]) each.addComponent(Hearer);
    scene.add(wall);
    if (isLate) scene.remove(person);
    await prepare(scene);
    run(scene, 2);
    if (isLate) scene.add(person);
    run(scene, 30);
    key(scene, 'down', 'KeyW');
    run(scene, 90);
    expect(told, `comes late: ${isLate}`).toEqual({ Person: [0, 0, 1], Wall: [0, 0, -1] });
  }
});
