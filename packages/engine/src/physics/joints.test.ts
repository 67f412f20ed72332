import { Vector3 } from 'three';
import { expect, test } from 'vitest';
import { Joint } from '../components/Joint';
import { RigidBody } from '../components/RigidBody';
import { GameObject } from '../core/GameObject';
import { box, ground, makeScene, placesOf, prepare, run, worldOf } from '../components/testing/physicsScene';

test('a hinge to the world turns about its axis alone, within its limits', async () => {
  const scene = makeScene();
  const door = box('Door', [1, 1, 0], { initialAngularVelocity: [0, 4, 0] });
  door.transform.scale = [1, 2, 0.1];
  door.addComponent(Joint, { anchor: [-0.5, 0, 0], axis: [0, 1, 0], limits: true, lowerAngle: -0.2, upperAngle: 0.8 });
  scene.add(door);
  await prepare(scene);
  let widest = 0;
  for (let i = 0; i < 240; i++) {
    run(scene, 1);
    // the edge with the hinge stays where it is
    expect(door.object3D.localToWorld(new Vector3(-0.5, 0, 0)).distanceTo(new Vector3(0.5, 1, 0))).toBeLessThan(0.02);
    widest = Math.max(widest, 2 * Math.asin(door.object3D.quaternion.y));
  }
  expect(widest).toBeGreaterThan(0.7);
  expect(widest).toBeLessThan(0.85);
});

test('a lantern on a ball joint swings below what carries it', async () => {
  const scene = makeScene();
  const hook = box('Hook', [0, 5, 0], { type: 'fixed' });
  const lantern = box('Lantern', [1, 4, 0]);
  lantern.transform.scale = [0.4, 0.4, 0.4];
  lantern.addComponent(Joint, { type: 'ball', partner: 'Hook', anchor: [-2.5, 2.5, 0] });
  scene.add(hook).add(lantern);
  await prepare(scene);
  const middle = worldOf(hook);
  const sides: number[] = [];
  for (let i = 0; i < 240; i++) {
    run(scene, 1);
    sides.push(worldOf(lantern).x);
    expect(worldOf(lantern).distanceTo(middle)).toBeCloseTo(Math.SQRT2, 1);
  }
  expect(Math.min(...sides)).toBeLessThan(-0.7);
  expect(Math.max(...sides)).toBeGreaterThan(0.7);
});

test.each([
  ['a hook', 'Hook'],
  ['the world', null],
])('a ball joint to %s leans no further than its cone, and turns freely about its axis', async (_name, partner) => {
  const scene = makeScene();
  const hook = box('Hook', [0, 5, 0], { type: 'fixed' });
  const lamp = box('Lamp', [0, 4, 0], { initialVelocity: [4, 0, 1], initialAngularVelocity: [0, 3, 0] });
  lamp.transform.scale = [0.2, 0.5, 0.2];
  lamp.addComponent(Joint, { type: 'ball', partner, anchor: [0, 2, 0], limits: true, coneAngle: 0.4 });
  scene.add(hook).add(lamp);
  await prepare(scene);
  const up = new Vector3();
  let widest = 0;
  let turned = 0;
  for (let i = 0; i < 240; i++) {
    run(scene, 1);
    up.set(0, 1, 0).applyQuaternion(lamp.object3D.quaternion);
    widest = Math.max(widest, up.angleTo(new Vector3(0, 1, 0)));
    const { y, w } = lamp.object3D.quaternion;
    turned = Math.max(turned, 2 * Math.abs(Math.atan2(y, w)));
    expect(lamp.object3D.localToWorld(new Vector3(0, 2, 0)).distanceTo(worldOf(hook))).toBeLessThan(0.03);
  }
  expect(widest).toBeGreaterThan(0.35);
  expect(widest).toBeLessThan(0.45);
  expect(turned).toBeGreaterThan(1.5);
});

test('fixed, slider with motor and spring', async () => {
  const scene = makeScene();
  const carrier = box('Carrier', [0, 3, 0], { type: 'fixed' });
  const stuck = box('Stuck', [1.2, 3, 0]);
  stuck.transform.rotation = [0, 0.5, 0];
  stuck.addComponent(Joint, { type: 'fixed', partner: 'Carrier' });
  const lift = box('Lift', [5, 1, 0]);
  lift.addComponent(Joint, {
    ...{ type: 'slider', axis: [0, 1, 0], limits: true, lowerDistance: 0, upperDistance: 2 },
    ...{ motor: true, motorSpeed: 1, motorStrength: 1000 },
  });
  const weight = box('Weight', [10, 2, 0], { mass: 2 });
  weight.addComponent(Joint, {
    ...{ type: 'spring', ownPartnerAnchor: true, partnerAnchor: [10, 4, 0] },
    ...{ restLength: 1, stiffness: 100, damping: 10 },
  });
  scene.add(carrier).add(stuck).add(lift).add(weight);
  await prepare(scene);
  const before = stuck.object3D.quaternion.clone();
  run(scene, 600);
  expect(
    worldOf(stuck)
      .toArray()
      .map((n) => Math.round(n * 100) / 100),
  ).toEqual([1.2, 3, 0]);
  expect(stuck.object3D.quaternion.angleTo(before)).toBeLessThan(0.01);
  expect(worldOf(lift).y).toBeCloseTo(3, 1);
  expect(worldOf(lift).x).toBeCloseTo(5, 2);
  // stretched by m g / k
  expect(worldOf(weight).y).toBeCloseTo(3 - (2 * 9.81) / 100, 1);
  scene.reset();
  expect(worldOf(weight).y).toBe(2);
});

test('a chain of bodies below one another holds, and plays the same twice', async () => {
  const scene = makeScene();
  let above: GameObject | null = null;
  for (let i = 0; i < 5; i++) {
    const link = box(
      `Link ${i}`,
      above ? [0.6, 0, 0] : [0, 6, 0],
      { angularDamping: 0.5 },
      { fit: false, size: [0.5, 0.1, 0.1] },
    );
    link.addComponent(Joint, { type: 'ball', partner: above ? above.id : null, anchor: [-0.3, 0, 0] });
    if (above) above.add(link);
    else scene.add(link);
    above = link;
  }
  await prepare(scene);
  run(scene, 400);
  const end = worldOf(above!);
  expect(end.y).toBeLessThan(4.5);
  expect(end.distanceTo(new Vector3(-0.3, 6, 0))).toBeLessThan(2.8);
  const places = placesOf(scene);
  scene.reset();
  run(scene, 400);
  expect(placesOf(scene)).toEqual(places);
});

test.each([
  [
    'no body',
    (object: GameObject) => object.removeComponent(object.getComponent(RigidBody)!),
    /'Odd' has no body: add a RigidBody/,
  ],
  [
    'a partner without one',
    (object: GameObject) => (object.getComponent(Joint)!.partner = 'Empty'),
    /'Odd', 'Empty', has no RigidBody: add one/,
  ],
  [
    'a partner that is gone',
    (object: GameObject) => (object.getComponent(Joint)!.partner = 'Nobody'),
    /partner of the Joint of 'Odd' is gone/,
  ],
  ['itself', (object: GameObject) => (object.getComponent(Joint)!.partner = 'Odd'), /is the same body: choose another/],
  ['no axis', (object: GameObject) => (object.getComponent(Joint)!.axis = [0, 0, 0]), /'Odd' has no axis/],
])('a joint with %s is told once, and the rest goes on', async (_, spoil, message) => {
  const scene = makeScene();
  const errors: string[] = [];
  scene.onComponentError = (component, error) => errors.push(`${component.typeName}: ${(error as Error).message}`);
  const odd = new GameObject('Odd', { id: 'Odd' });
  odd.addComponent(RigidBody);
  odd.addComponent(Joint);
  spoil(odd);
  const cube = box('Cube', [3, 5, 0]);
  scene
    .add(ground())
    .add(odd)
    .add(new GameObject('Empty', { id: 'Empty' }))
    .add(cube);
  await prepare(scene);
  run(scene, 200);
  expect(errors).toHaveLength(1);
  expect(errors[0]).toMatch(message);
  expect(worldOf(cube).y).toBeCloseTo(0.5, 1);
});
