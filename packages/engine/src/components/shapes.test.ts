import { Box3, Raycaster, Vector3, type Mesh } from 'three';
import { beforeEach, describe, expect, test } from 'vitest';
import { bakeSignature } from '../bake/bakeSignature';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import type { ComponentClass } from '../core/ComponentClass';
import { Collider } from './Collider';
import { ObjectRenderer } from './ObjectRenderer';
import { Room } from './Room';
import { Wall } from './Wall';

let scene: Scene;

beforeEach(() => {
  scene = new Scene();
});

function build<T extends Wall | Room>(
  type: ComponentClass<T>,
  values: Record<string, number | string | boolean> = {},
): T {
  const object = new GameObject(type.typeName);
  object.addComponent(ObjectRenderer);
  scene.add(object);
  return object.addComponent(type, values);
}

const meshOf = (shape: Wall | Room): Mesh => shape.gameObject.getComponent(ObjectRenderer)!.three!;

const boxOf = (shape: Wall | Room): number[] => {
  const { min, max } = new Box3().setFromObject(meshOf(shape));
  return [...min.toArray(), ...max.toArray()].map((each) => Number(each.toFixed(4)));
};

/** Whether a shape lies between two points (m). */
function isBlocked(shape: Wall | Room, from: [number, number, number], to: [number, number, number]): boolean {
  scene.three.updateMatrixWorld(true);
  const [eye, end] = [new Vector3(...from), new Vector3(...to)];
  const ray = new Raycaster(eye, end.clone().sub(eye).normalize(), 0, eye.distanceTo(end));
  return ray.intersectObject(meshOf(shape)).length > 0;
}

describe('a wall', () => {
  test('stands on the ground with a door of ordinary size, and is drawn in place of the mesh', () => {
    const wall = build(Wall);
    expect(boxOf(wall)).toEqual([-2, 0, -0.075, 2, 2.6, 0.075]);
    expect(isBlocked(wall, [0, 1.9, 1], [0, 1.9, -1])).toBe(false);
    expect(isBlocked(wall, [0, 2.2, 1], [0, 2.2, -1])).toBe(true);
    expect(isBlocked(wall, [0.5, 1, 1], [0.5, 1, -1])).toBe(true);
  });

  test('changes with its fields', () => {
    const wall = build(Wall, { opening: 'window', openingWidth: 1, openingHeight: 1, sill: 0.9, openingOffset: 1 });
    expect(isBlocked(wall, [1, 1.4, 1], [1, 1.4, -1])).toBe(false);
    expect(isBlocked(wall, [1, 0.5, 1], [1, 0.5, -1])).toBe(true);
    wall.opening = 'none';
    expect(isBlocked(wall, [1, 1.4, 1], [1, 1.4, -1])).toBe(true);
    wall.length = 6;
    expect(boxOf(wall)[3]).toBe(3);
  });

  test('keeps a hole within itself: moved along, narrower and lower', () => {
    const wall = build(Wall, { length: 2, openingWidth: 5, openingHeight: 9, openingOffset: 50 });
    expect(isBlocked(wall, [0.9, 1, 1], [0.9, 1, -1])).toBe(false);
    for (const [x, y] of [
      [0.98, 1],
      [-0.98, 1],
      [0, 2.58],
    ] as const)
      expect(isBlocked(wall, [x, y, 1], [x, y, -1])).toBe(true);
    wall.length = 0.05;
    expect(boxOf(wall)[3]).toBe(0.025);
  });
});

describe('a room', () => {
  test('is 4 × 3 × 2.6 m inside, and one enters by its door', () => {
    const room = build(Room);
    expect(boxOf(room)).toEqual([-2.15, -0.15, -1.65, 2.15, 2.75, 1.65]);
    expect(isBlocked(room, [0, 1, 4], [0, 1, 0])).toBe(false);
    expect(isBlocked(room, [0, 1, -4], [0, 1, 0])).toBe(true);
    expect(isBlocked(room, [0, 5, 0], [0, 1, 0])).toBe(true);
    expect(isBlocked(room, [-1.99, 0.01, -1.49], [1.99, 2.59, 1.49])).toBe(false);
  });

  test('has its door and its window where they are asked for, and no ceiling if none is', () => {
    const room = build(Room, { door: 'left', doorOffset: 0.5, window: 'back', ceiling: false });
    expect(isBlocked(room, [0, 1, 4], [0, 1, 0])).toBe(true);
    expect(isBlocked(room, [-4, 1, 0.5], [0, 1, 0.5])).toBe(false);
    expect(isBlocked(room, [0, 1.5, -4], [0, 1.5, 0])).toBe(false);
    expect(isBlocked(room, [0, 0.5, -4], [0, 0.5, 0])).toBe(true);
    expect(isBlocked(room, [0, 5, 0], [0, 1, 0])).toBe(false);
  });

  test('may have door and window in one wall', () => {
    const room = build(Room, { window: 'front', windowOffset: 1.2, windowWidth: 0.8 });
    expect(isBlocked(room, [0, 1, 4], [0, 1, 0])).toBe(false);
    expect(isBlocked(room, [1.2, 1.5, 4], [1.2, 1.5, 0])).toBe(false);
    expect(isBlocked(room, [1.2, 0.5, 4], [1.2, 0.5, 0])).toBe(true);
  });
});

describe('what draws it', () => {
  test('goes back to its mesh when the component is switched off or removed, and lets go of the shape', () => {
    const wall = build(Wall);
    const own = meshOf(wall).geometry;
    const uses = (): number => scene.assets.uses.uses(own);
    expect(uses()).toBe(1);
    wall.enabled = false;
    expect(uses()).toBe(0);
    expect(meshOf(wall).geometry).toBe(
      scene.assets.mesh('box', wall.gameObject.getComponent(ObjectRenderer)!.creaseAngle),
    );
    wall.enabled = true;
    expect(meshOf(wall).geometry).toBe(own);
    const { gameObject } = wall;
    gameObject.removeComponent(wall);
    expect(gameObject.getComponent(ObjectRenderer)!.three!.geometry).not.toBe(own);
    expect(uses()).toBe(0);
  });

  test('leaves nothing behind when the object goes, and comes back with it', () => {
    const wall = build(Wall);
    const { gameObject } = wall;
    const before = scene.assets.uses.size;
    scene.remove(gameObject);
    expect(scene.assets.uses.size).toBeLessThan(before);
    expect(gameObject.getComponent(ObjectRenderer)!.three).toBeNull();
    scene.add(gameObject);
    expect(boxOf(wall)[3]).toBe(2);
    expect(scene.assets.uses.size).toBe(before);
  });

  test('takes no other component for one that makes shapes', () => {
    const object = new GameObject('Crate');
    object.addComponent(ObjectRenderer);
    object.addComponent(Collider);
    scene.add(object);
    expect(new Box3().setFromObject(object.object3D).max.x).toBe(0.5);
  });
});

test('a bake is out of date once a baked wall is another', () => {
  const wall = build(Wall);
  wall.gameObject.isStatic = true;
  const before = bakeSignature(scene);
  wall.openingWidth = 1.2;
  expect(bakeSignature(scene)).not.toBe(before);
});
