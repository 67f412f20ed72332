import { Quaternion } from 'three';
import { expect, test } from 'vitest';
import { RigidBody } from '../components/RigidBody';
import { Component } from '../core/Component';
import { box, makeScene, prepare, run, worldOf } from '../components/testing/physicsScene';

test('forces, impulses, velocities and teleports by script', async () => {
  const scene = makeScene();
  const bodies = ['a', 'b', 'c', 'd'].map((name, i) =>
    box(name, [i * 5, 0, 0], { mass: 2, gravityScale: 0, angularDamping: 0 }),
  );
  class Pusher extends Component {
    static override readonly typeName = 'Pusher';
    override start(): void {
      const body = this.gameObject.getComponent(RigidBody)!;
      if (this.gameObject.id === 'a') body.applyImpulse([0, 4, 0]);
      if (this.gameObject.id === 'c') body.velocity = [0, 0, 1];
      if (this.gameObject.id === 'd') body.teleport([0, 50, 0], new Quaternion(0, 1, 0, 0));
    }
    override update(): void {
      if (this.gameObject.id === 'b') this.gameObject.getComponent(RigidBody)!.applyForce([0, 4, 0]);
    }
  }
  for (const each of bodies) each.addComponent(Pusher);
  for (const each of bodies) scene.add(each);
  await prepare(scene);
  run(scene, 60);
  const [a, b, c, d] = bodies;
  expect(worldOf(a).y).toBeCloseTo((2 * 59) / 60, 3);
  expect(b.getComponent(RigidBody)!.velocity.y).toBeCloseTo(2, 3);
  expect(worldOf(c).z).toBeCloseTo(59 / 60, 3);
  expect(worldOf(d).toArray()).toEqual([0, 50, 0]);
  scene.reset();
  expect(worldOf(d).toArray()).toEqual([15, 0, 0]);
});

test('a force or an impulse at a point turns a body about its centre of mass, wherever its origin is', async () => {
  const scene = makeScene();
  scene.settings.gravity = [0, 0, 0];
  const bodyPushed = (x: number, push: (body: RigidBody) => void): RigidBody => {
    // the collider, and therefore the centre of mass, is offset by 1 m
    const object = box(`Body ${x}`, [x, 0, 0], { angularDamping: 0 }, { fit: false, offset: [1, 0, 0] });
    const body = object.getComponent(RigidBody)!;
    class Pusher extends Component {
      static override readonly typeName = 'Pusher';
      override start(): void {
        push(body);
      }
    }
    object.addComponent(Pusher);
    scene.add(object);
    return body;
  };
  const bodies = [0, 0.5, -0.5].flatMap((arm, i) => [
    // 60 N during a frame of 1/60 s: 1 N·s
    bodyPushed(20 * i, (body) => body.applyForce([0, 60, 0], [20 * i + 1 + arm, 0, 0])),
    bodyPushed(20 * i + 10, (body) => body.applyImpulse([0, 1, 0], [20 * i + 11 + arm, 0, 0])),
  ]);
  await prepare(scene);
  run(scene, 4);
  // 0.5 N·m·s on a cube of 1 kg and 1 m, whose moment of inertia is 1/6 kg·m²
  [0, 0, 3, 3, -3, -3].forEach((turn, i) => expect(bodies[i].angularVelocity.z, `body ${i}`).toBeCloseTo(turn, 2));
});
