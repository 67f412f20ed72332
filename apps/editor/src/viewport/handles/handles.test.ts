import { GameObject, ObjectRenderer, Scene } from '@farol/engine';
import { Object3D, OrthographicCamera, PerspectiveCamera, Quaternion, Ray, Vector3 } from 'three';
import { describe, expect, it } from 'vitest';
import { amountText } from './amountText';
import { DragSnap } from './DragSnap';
import { TypedAmounts } from './TypedAmounts';

type Triple = [number, number, number];

const type = (amounts: TypedAmounts, keys: string): void => {
  for (const key of keys.split(' ')) expect(amounts.press({ key, shiftKey: false })).toBe(true);
};

describe('TypedAmounts', () => {
  it('reads numbers and expressions as they are typed, axis by axis', () => {
    const amounts = new TypedAmounts(3);
    expect([amounts.isTyped, amounts.valueOf(0)]).toEqual([false, null]);
    type(amounts, '- 1 . 5');
    expect([amounts.isTyped, amounts.valueOf(0), amounts.valueOf(1)]).toEqual([true, -1.5, null]);
    type(amounts, 'Tab 1 / 4 Tab 2 , 5');
    expect([0, 1, 2].map((axis) => amounts.valueOf(axis))).toEqual([-1.5, 0.25, 2.5]);
    expect(amounts.press({ key: 'Tab', shiftKey: true })).toBe(true);
    expect(amounts.at).toBe(1);
  });

  it('has no value for what is no number yet, and says what never becomes one', () => {
    const amounts = new TypedAmounts(1);
    type(amounts, '2 *');
    expect([amounts.valueOf(0), amounts.isWrong(0)]).toEqual([null, false]);
    type(amounts, ')');
    expect([amounts.valueOf(0), amounts.isWrong(0)]).toEqual([null, true]);
  });

  it('takes back, and leaves other keys to others', () => {
    const amounts = new TypedAmounts(2);
    type(amounts, '1 Tab 2 Backspace Backspace Backspace');
    expect([amounts.isTyped, amounts.at]).toEqual([false, 0]);
    for (const key of ['x', 'F2', 'Shift', ' ']) expect(amounts.press({ key, shiftKey: false })).toBe(false);
  });
});

describe('amountText', () => {
  it('says how far, with its sign and unit', () => {
    expect(amountText('translate', 1.2)).toBe('+1.20 m');
    expect(amountText('translate', -0.012)).toBe('−0.012 m');
    expect(amountText('translate', -1e-9)).toBe('+0.00 m');
    expect(amountText('rotate', Math.PI / 4)).toBe('+45°');
    expect(amountText('rotate', -0.5)).toBe('−28.6°');
    expect(amountText('scale', 1.5)).toBe('×1.50');
  });
});

describe('DragSnap', () => {
  const camera = new PerspectiveCamera();

  function box(scene: Scene, position: Triple, scale: Triple = [1, 1, 1]): GameObject {
    const object = new GameObject('Box');
    object.addComponent(ObjectRenderer, { mesh: 'box' });
    object.transform.position = position;
    object.transform.scale = scale;
    scene.add(object);
    scene.three.updateMatrixWorld();
    return object;
  }

  /** A drag of a box at the origin, with a wall at x = 3 and a floor whose top is at y = -1. */
  function drag(): { snap: DragSnap; pivot: Object3D } {
    const scene = new Scene();
    const dragged = box(scene, [0, 0, 0]);
    box(scene, [3.5, 0, 0], [1, 10, 10]);
    box(scene, [0, -2, 0], [20, 2, 20]);
    const pivot = new Object3D();
    return { snap: new DragSnap(scene, [dragged], pivot), pivot };
  }

  const free = (): void => {};
  const aim = (from: Triple, to: Triple): Ray => {
    const origin = new Vector3(...from);
    return new Ray(origin, new Vector3(...to).sub(origin).normalize());
  };

  it('holds what is dragged to the surface under the pointer, touching it, through what is dragged', () => {
    const { snap, pivot } = drag();
    expect(snap.toSurface(pivot, aim([-5, 0, 0], [3, 0, 0]), camera, false, free)).toBe(true);
    expect(pivot.position.distanceTo(new Vector3(2.5, 0, 0))).toBeLessThan(1e-6);
    snap.toSurface(pivot, aim([0, 5, 0], [1, -1, 2]), camera, false, free);
    expect(pivot.position.distanceTo(new Vector3(1, -0.5, 2))).toBeLessThan(1e-6);
    const onlyX = (way: Vector3): void => void way.set(way.x, 0, 0);
    snap.toSurface(pivot, aim([0, 5, 0], [1, -1, 2]), camera, false, onlyX);
    expect(pivot.position.distanceTo(new Vector3(1, 0, 0))).toBeLessThan(1e-6);
    expect(snap.toSurface(pivot, aim([0, 5, 0], [0, 6, 0]), camera, false, free)).toBe(false);
  });

  it('turns it along the surface, its foot on it', () => {
    const { snap, pivot } = drag();
    snap.toSurface(pivot, aim([-5, 1, 0], [3, 1, 0]), camera, true, free);
    expect(pivot.position.distanceTo(new Vector3(2.5, 1, 0))).toBeLessThan(1e-6);
    expect(new Vector3(0, 1, 0).applyQuaternion(pivot.quaternion).distanceTo(new Vector3(-1, 0, 0))).toBeLessThan(1e-6);
    snap.toSurface(pivot, aim([0, 5, 0], [1, -1, 2]), camera, false, free);
    expect(pivot.quaternion.angleTo(new Quaternion())).toBeLessThan(1e-6);
  });

  it('holds the nearest vertex of what is dragged to that under the pointer', () => {
    const { snap, pivot } = drag();
    // the pointer is near the corner of the wall at (3, 5, 5); the box has been dragged close to it
    pivot.position.set(2, 4, 4);
    const vertex = snap.toVertex(pivot, aim([-5, 4.8, 4.9], [3, 4.8, 4.9]), camera, free);
    expect(vertex!.distanceTo(new Vector3(3, 5, 5))).toBeLessThan(1e-6);
    expect(pivot.position.distanceTo(new Vector3(2.5, 4.5, 4.5))).toBeLessThan(1e-6);
  });

  it('finds a vertex beside which the pointer just misses: at a silhouette, before the sky or the floor', () => {
    const { snap, pivot } = drag();
    const corner = new Vector3(3, 5, 5);
    const past = aim([-5, 5.05, 13], [3, 5.05, 5.05]);
    expect(snap.toVertex(pivot, past, camera, free)?.distanceTo(corner)).toBeLessThan(1e-6);
    // from above the ray continues to the floor, whose own corners are far
    const down = aim([2.9, 12, 5.06], [2.9, -1, 5.06]);
    expect(snap.toVertex(pivot, down, camera, free)!.distanceTo(corner)).toBeLessThan(1e-6);
    expect(snap.toVertex(pivot, aim([-5, 6, 6], [3, 9, 9]), camera, free)).toBeNull();
  });

  it('takes no vertex that is hidden behind what the pointer is on', () => {
    const { snap, pivot } = drag();
    // the wall's corners at x = 4 are directly behind those at x = 3
    const vertex = snap.toVertex(pivot, aim([-5, 4.99, 4.99], [3, 4.99, 4.99]), camera, free);
    expect(vertex!.distanceTo(new Vector3(3, 5, 5))).toBeLessThan(1e-6);
  });

  it('reaches as far as the picture is large, without perspective too', () => {
    const { snap, pivot } = drag();
    const flat = new OrthographicCamera(-10, 10, 10, -10);
    const near = aim([-5, 5.2, 13], [3, 5.2, 5.2]);
    expect(snap.toVertex(pivot, near, flat, free)!.distanceTo(new Vector3(3, 5, 5))).toBeLessThan(1e-6);
    flat.zoom = 10;
    expect(snap.toVertex(pivot, near, flat, free)).toBeNull();
  });
});
