import { expect, test } from 'vitest';
import { Collider } from '../components/Collider';
import { Component } from '../core/Component';
import type { CollisionEvent } from './CollisionEvent';
import { box, ground, makeScene, prepare, run } from '../components/testing/physicsScene';

const heard: string[] = [];

class Listener extends Component {
  static override readonly typeName = 'Listener';
  onCollisionEnter(event: CollisionEvent): void {
    const { x, y, z } = event.normal!;
    heard.push(`${this.gameObject.name} meets ${event.other.name} ${[x, y, z].map((n) => Math.round(n) + 0).join()}`);
  }
  onCollisionExit(event: CollisionEvent): void {
    heard.push(`${this.gameObject.name} leaves ${event.other.name}`);
  }
  onTriggerEnter(event: CollisionEvent): void {
    heard.push(`${this.gameObject.name} in ${event.other.name}`);
  }
  onTriggerExit(event: CollisionEvent): void {
    heard.push(`${this.gameObject.name} out of ${event.other.name}`);
  }
}

test('collisions and sensors call the methods of both objects, in the order of steps and tree', async () => {
  heard.length = 0;
  const scene = makeScene();
  const cube = box('Cube', [0, 4, 0], { lockRotationX: true, lockRotationZ: true });
  // a second collider causes no second event
  cube.addComponent(Collider, { fit: false, size: [0.5, 1, 0.5] });
  const gate = box('Gate', [0, 2, 0], null, { sensor: true });
  const floor = ground();
  for (const each of [cube, gate, floor]) each.addComponent(Listener);
  scene.add(floor).add(gate).add(cube);
  await prepare(scene);
  run(scene, 240);
  expect(heard).toEqual([
    'Gate in Cube',
    'Cube in Gate',
    'Gate out of Cube',
    'Cube out of Gate',
    'Ground meets Cube 0,-1,0',
    'Cube meets Ground 0,1,0',
  ]);
  heard.length = 0;
  scene.remove(cube);
  run(scene, 2);
  expect(heard).toEqual(['Ground leaves Cube']);
});
