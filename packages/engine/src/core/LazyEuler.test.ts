import { Euler, type EulerOrder, Object3D, Quaternion, Vector3 } from 'three';
import { expect, test, vi } from 'vitest';
import { createRandom } from '../base/createRandom';
import { GameObject } from './GameObject';

const orders: readonly EulerOrder[] = ['XYZ', 'YXZ', 'ZXY'];

test("the rotation of an object is three's, whichever way it is written and read", () => {
  const random = createRandom(11);
  const angle = (): number => (random() - 0.5) * 6;
  const own = new GameObject().object3D;
  const plain = new Object3D();
  const axis = new Vector3(1, 2, -1).normalize();
  const acts: readonly ((object: Object3D, n: number) => unknown)[] = [
    ({ quaternion }, n) => quaternion.set(Math.sin(n), 0.3, 0.1, Math.cos(n)).normalize(),
    ({ rotation }, n) => rotation.set(n, -n / 2, 0.2),
    ({ rotation }, n) => (rotation.y = n),
    (object, n) => object.rotateOnAxis(axis, n),
    ({ rotation }, n) => (rotation.order = orders[Math.abs(Math.round(n)) % 3]),
    ({ rotation }, n) => rotation.copy(new Euler(n, 0.4, 0.1)),
    ({ quaternion }, n) => quaternion.setFromEuler(new Euler(n, 1, n)),
    (object, n) => object.copy(new Object3D().rotateX(n), false),
  ];
  for (let i = 0; i < 400; i++) {
    const act = acts[Math.floor(random() * acts.length)];
    const n = angle();
    act(own, n);
    act(plain, n);
    // angles are not read after every change
    if (random() < 0.5) continue;
    expect(own.rotation.toArray()).toEqual(plain.rotation.toArray());
    expect(own.quaternion.toArray()).toEqual(plain.quaternion.toArray());
    expect(new Euler().copy(own.rotation).equals(plain.rotation)).toBe(true);
    expect(new Quaternion().setFromEuler(own.rotation).equals(new Quaternion().setFromEuler(plain.rotation))).toBe(
      true,
    );
    expect([...own.rotation]).toEqual([...plain.rotation]);
  }
});

test('angles that nobody reads are not computed', () => {
  const { object3D } = new GameObject();
  const compute = vi.spyOn(Euler.prototype, 'setFromQuaternion');
  for (let i = 1; i < 9; i++) object3D.quaternion.set(0, Math.sin(i), 0, Math.cos(i));
  expect(compute).not.toHaveBeenCalled();
  expect(object3D.rotation.y).not.toBe(0);
  expect(Math.abs(object3D.rotation.x)).toBeCloseTo(Math.PI);
  expect(compute).toHaveBeenCalledTimes(1);
  compute.mockRestore();
});
