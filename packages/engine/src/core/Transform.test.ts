import { Matrix4, Vector3 } from 'three';
import { beforeEach, describe, expect, test } from 'vitest';
import { GameObject } from '../core/GameObject';
import { Scene } from '../core/Scene';
import type { Transform } from './Transform';

let parent: GameObject;
let child: GameObject;
let transform: Transform;

beforeEach(() => {
  parent = new GameObject('parent');
  child = new GameObject('child');
  parent.add(child);
  new Scene().add(parent);
  parent.transform.position = [5, 0, 0];
  parent.transform.rotation = [0, Math.PI / 2, 0];
  transform = child.transform;
});

/** Coordinates rounded to nine decimals. */
const rounded = (vector: Vector3): number[] => vector.toArray().map((value) => Math.round(value * 1e9) / 1e9 + 0);

describe('axes', () => {
  test('right, top and front are +X, +Y and -Z as the parents turn them', () => {
    expect(rounded(transform.right)).toEqual([0, 0, -1]);
    expect(rounded(transform.top)).toEqual([0, 1, 0]);
    expect(rounded(transform.front)).toEqual([-1, 0, 0]);
  });

  test('stay of length 1 under a scale', () => {
    transform.scale = [3, 0.2, 7];
    for (const axis of [transform.right, transform.top, transform.front]) expect(axis.length()).toBeCloseTo(1, 9);
  });
});

describe('translate', () => {
  test('moves along the axes of the world', () => {
    transform.translate([0, 2, 3]);
    expect(rounded(transform.worldPosition)).toEqual([5, 2, 3]);
  });

  test('local moves along the own axes', () => {
    transform.rotation = [0, Math.PI / 2, 0];
    transform.translateLocal({ x: 0, y: 0, z: -2 });
    expect(rounded(transform.worldPosition)).toEqual([5, 0, 2]);
  });
});

describe('rotate', () => {
  test('turns about an axis of the world, in place', () => {
    transform.position = [1, 0, 0];
    const before = transform.worldPosition;
    transform.rotate(Math.PI / 2, [0, 0, 1]);
    expect(rounded(transform.front)).toEqual([0, -1, 0]);
    expect(transform.worldPosition.distanceTo(before)).toBeCloseTo(0, 9);
  });

  test('local turns about an own axis', () => {
    transform.rotateLocal(Math.PI / 2, [1, 0, 0]);
    expect(rounded(transform.front)).toEqual([0, 1, 0]);
  });
});

describe('lookAt', () => {
  test('turns the front to a point of the world', () => {
    transform.lookAt([5, 0, 10]);
    expect(rounded(transform.front)).toEqual([0, 0, 1]);
  });

  test('with an eye puts the object there first', () => {
    transform.lookAt([1, 2, 3], [1, 2, -7]);
    expect(rounded(transform.worldPosition)).toEqual([1, 2, 3]);
    expect(rounded(transform.front)).toEqual([0, 0, -1]);
    expect(rounded(transform.top)).toEqual([0, 1, 0]);
  });

  test('keeps to the up that is asked for', () => {
    transform.lookAt([0, 0, 0], [0, 0, -1], [1, 0, 0]);
    expect(rounded(transform.top)).toEqual([1, 0, 0]);
  });
});

test('the model matrix can be set and read, through parents', () => {
  const wanted = new Matrix4()
    .makeRotationX(0.4)
    .setPosition(1, 2, 3)
    .scale(new Vector3(2, 2, 2));
  transform.modelMatrix = wanted;
  transform.modelMatrix.elements.forEach((element, i) => expect(element).toBeCloseTo(wanted.elements[i], 9));
  expect(child.object3D.parent).toBe(parent.object3D);
});

test('get answers with where the object is, getAuthored with where it was put; reset puts it back', () => {
  transform.position = [1, 2, 3];
  child.object3D.position.x = 50;
  child.object3D.quaternion.set(1, 0, 0, 0);
  expect(transform.position).toEqual([50, 2, 3]);
  expect(transform.getAuthored('position')).toEqual([1, 2, 3]);
  transform.position = [1, 2, 3];
  expect(child.object3D.position.x).toBe(1);
  child.scene!.reset();
  expect(transform.rotation).toEqual([0, 0, 0]);
});
