import type { Vector3Tuple } from '@farol/editing/fields';
import { Euler, Vector3 } from 'three';
import { expect, test } from 'vitest';
import { RigidBody } from '../components/RigidBody';
import type { GameObject } from '../core/GameObject';
import type { Scene } from '../core/Scene';
import type { colliderFields } from './colliderFields';
import type { rigidBodyFields } from './rigidBodyFields';
import { box, ground, makeScene, prepare, run, type Values, worldOf } from '../components/testing/physicsScene';

const GRAVITY = 9.81;

interface Thrown {
  readonly scene: Scene;
  readonly cube: GameObject;
  readonly body: RigidBody;
}

/** A box of 1 m above the ground, in a scene ready to play. @param height - height of its centre (m) */
async function thrown(body: Values, collider: Values = {}, height = 100, floor = ground()): Promise<Thrown> {
  const scene = makeScene();
  const cube = box('Cube', [0, height, 0], body, collider);
  scene.add(floor).add(cube);
  await prepare(scene);
  return { scene, cube, body: cube.getComponent(RigidBody)! };
}

/** Velocity (m/s) and angular velocity (rad/s) after 60 steps without gravity, from 1 along and about each axis. */
async function velocities(values: Values): Promise<number[]> {
  const start: Values = {
    ...{ initialVelocity: [1, 1, 1], initialAngularVelocity: [1, 1, 1] },
    ...{ gravityScale: 0, angularDamping: 0 },
  };
  const { scene, body } = await thrown({ ...start, ...values });
  run(scene, 60);
  return [...body.velocity, ...body.angularVelocity];
}

/** Speed along x that an impulse of 12 N·s gives (m/s). */
async function pushed(body: Values, collider: Values = {}): Promise<number> {
  const all = await thrown({ ...body, gravityScale: 0 }, collider);
  run(all.scene, 1);
  all.body.applyImpulse([12, 0, 0]);
  run(all.scene, 1);
  return all.body.velocity.x;
}

/** Velocity and angular velocity of a resting body without gravity, after pushes along and about all axes. */
async function shoved(values: Values): Promise<number[]> {
  const { scene, body } = await thrown({ ...values, gravityScale: 0, angularDamping: 0 });
  run(scene, 1);
  body.applyImpulse([1, 1, 1]);
  // for 1/60 s, on a cube of 1 kg and 1 m, whose moment of inertia is 1/6
  body.applyTorque([10, 10, 10]);
  run(scene, 1);
  return [...body.velocity, ...body.angularVelocity];
}

const expectNear = (values: readonly number[], expected: readonly number[]): void =>
  values.forEach((value, i) => expect(value, String(i)).toBeCloseTo(expected[i], 3));

/** Checks that each field of a RigidBody has its physical effect; a new field that is not listed is a type error. */
const bodyCases: Readonly<Record<keyof typeof rigidBodyFields, () => Promise<void>>> = {
  async type() {
    for (const type of ['fixed', 'kinematic']) {
      const { scene, cube } = await thrown({ type });
      run(scene, 60);
      expect(worldOf(cube).y).toBe(100);
    }
  },
  mass: async () => expect(await pushed({ mass: 4 })).toBeCloseTo(3, 4),
  massFrom: async () => expect(await pushed({ massFrom: 'density', mass: 4 }, { density: 6 })).toBeCloseTo(2, 4),
  async gravityScale() {
    const { scene, body } = await thrown({ gravityScale: 0.5 });
    run(scene, 60);
    expect(body.velocity.y).toBeCloseTo(-0.5 * GRAVITY, 2);
  },
  async linearDamping() {
    const left = (1 + 2 / 60) ** -60; // damping of the speed, step by step
    expectNear(await velocities({ linearDamping: 2 }), [left, left, left, 1, 1, 1]);
  },
  async angularDamping() {
    const left = (1 + 2 / 60) ** -60;
    expectNear(await velocities({ angularDamping: 2 }), [1, 1, 1, left, left, left]);
  },
  async continuous() {
    const beyond = async (continuous: boolean): Promise<boolean> => {
      // Rapier lets nothing tunnel through fixed bodies in any case, so the wall is kinematic
      const wall = box('Wall', [23, 0, 0], { type: 'kinematic' });
      wall.transform.scale = [0.1, 50, 50];
      const values = { continuous, gravityScale: 0, initialVelocity: [300, 0, 0] } as const;
      const { scene, cube } = await thrown(values, {}, 0, wall);
      run(scene, 10);
      return worldOf(cube).x > 24;
    };
    expect([await beyond(false), await beyond(true)]).toEqual([true, false]);
  },
  initialVelocity: async () => expectNear(await velocities({ initialVelocity: [1, 2, 3] }), [1, 2, 3, 1, 1, 1]),
  initialAngularVelocity: async () =>
    expectNear(await velocities({ initialAngularVelocity: [0, 2, 0] }), [1, 1, 1, 0, 2, 0]),
  lockPositionX: async () => expectNear(await shoved({ lockPositionX: true }), [0, 1, 1, 1, 1, 1]),
  lockPositionY: async () => expectNear(await shoved({ lockPositionY: true }), [1, 0, 1, 1, 1, 1]),
  lockPositionZ: async () => expectNear(await shoved({ lockPositionZ: true }), [1, 1, 0, 1, 1, 1]),
  lockRotationX: async () => expectNear(await shoved({ lockRotationX: true }), [1, 1, 1, 0, 1, 1]),
  lockRotationY: async () => expectNear(await shoved({ lockRotationY: true }), [1, 1, 1, 1, 0, 1]),
  lockRotationZ: async () => expectNear(await shoved({ lockRotationZ: true }), [1, 1, 1, 1, 1, 0]),
};

const SLOPE = (20 * Math.PI) / 180;
const TURN: Vector3Tuple = [0, 0, SLOPE];
const uphill = new Vector3(1, 0, 0).applyEuler(new Euler(...TURN));
const normal = new Vector3(0, 1, 0).applyEuler(new Euler(...TURN));

/** Distance (m) that a box has slid down a slope of 20° after 1.5 s. @param slope - friction of the slope */
async function slid(slope: number, friction: number): Promise<number> {
  const plane = box('Slope', [0, -0.5, 0], null, { friction: slope });
  plane.transform.scale = [40, 1, 4];
  // its top face contains the origin
  plane.transform.position = normal.clone().multiplyScalar(-0.5).toArray();
  plane.transform.rotation = TURN;
  const scene = makeScene();
  const cube = box('Cube', normal.clone().multiplyScalar(0.5).toArray(), {}, { friction });
  cube.transform.rotation = TURN;
  scene.add(plane).add(cube);
  await prepare(scene);
  run(scene, 91);
  return -worldOf(cube).dot(uphill);
}

/** Height of a resting object's centre on the ground (m). */
async function rests(collider: Values): Promise<number> {
  const { scene, cube } = await thrown({}, { fit: false, ...collider }, 3);
  run(scene, 240);
  return worldOf(cube).y;
}

/** Upward speed just after a fall of 2 m (m/s). */
async function rebound(restitution: number): Promise<number> {
  const { scene, body } = await thrown({}, { restitution }, 2.5);
  let speed = 0;
  for (let i = 0; i < 60; i++) {
    run(scene, 1);
    speed = Math.max(speed, body.velocity.y);
  }
  return speed;
}

/** Checks that each field of a Collider has its effect, likewise. */
const colliderCases: Readonly<Record<keyof typeof colliderFields, () => Promise<void>>> = {
  async shape() {
    expect(await rests({ shape: 'sphere', size: [3, 1, 2] })).toBeCloseTo(1.5, 2);
    expect(await rests({ shape: 'box', size: [3, 1, 2] })).toBeCloseTo(0.5, 2);
  },
  async axis() {
    expect(await rests({ shape: 'cylinder', axis: 'x', size: [3, 1, 2] })).toBeCloseTo(1, 2);
    expect(await rests({ shape: 'cylinder', axis: 'y', size: [3, 1, 2] })).toBeCloseTo(0.5, 2);
  },
  fit: async () => expect(await rests({ fit: true, size: [3, 3, 3] })).toBeCloseTo(0.5, 2),
  size: async () => expect(await rests({ size: [3, 2, 3] })).toBeCloseTo(1, 2),
  offset: async () => expect(await rests({ size: [3, 1, 3], offset: [0, 0.2, 0] })).toBeCloseTo(0.3, 2),
  sensor: async () => expect(await rests({ sensor: true })).toBeLessThan(-10),
  density: async () => expect(await pushed({ massFrom: 'density' }, { density: 8 })).toBeCloseTo(1.5, 4),
  async friction() {
    const [sin, cos] = [Math.sin(SLOPE), Math.cos(SLOPE)];
    // tan 20° is 0.364
    for (const friction of [0.38, 0.5, 1]) expect(Math.abs(await slid(friction, friction))).toBeLessThan(0.001);
    for (const friction of [0, 0.1, 0.2, 0.3]) {
      const distance = 0.5 * GRAVITY * (sin - friction * cos) * 1.5 * (1.5 + 1 / 240); // summed as in `fallen`
      for (const part of [0, 1, 2]) {
        // friction is the mean of both surfaces
        const found = await slid(friction * part, friction * (2 - part));
        expect(Math.abs(found - distance), `${friction}: ${found} of ${distance} m`).toBeLessThan(0.01);
      }
    }
  },
  async restitution() {
    const fast = Math.sqrt(2 * GRAVITY * 2);
    expect(await rebound(0)).toBeLessThan(0.1);
    for (const restitution of [0.25, 0.5, 0.8, 1]) {
      const speed = await rebound(restitution);
      // minus the effect of gravity until the end of the step
      expect(speed / (restitution * fast)).toBeGreaterThan(0.95);
      expect(speed / (restitution * fast)).toBeLessThan(1.001);
    }
  },
};

test.each([
  ...Object.entries(bodyCases).map(([field, check]) => [`RigidBody.${field}`, check] as const),
  ...Object.entries(colliderCases).map(([field, check]) => [`Collider.${field}`, check] as const),
])('%s', async (_, check) => {
  expect.hasAssertions();
  await check();
});
