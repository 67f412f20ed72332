import { Matrix4, Object3D, Quaternion, Vector3 } from 'three';
import { expect, test } from 'vitest';
import { mirrored, worldRotation } from './worldRotation';

/** All combinations of signs of a scale. */
const mirrors = [1, -1].flatMap((x) => [1, -1].flatMap((y) => [1, -1].map((z) => new Vector3(x, y, z))));
const turn = (x: number, y: number, z: number, w: number): Quaternion => new Quaternion(x, y, z, w).normalize();
const rotationOf = (quaternion: Quaternion): Matrix4 => new Matrix4().makeRotationFromQuaternion(quaternion);

const differenceOf = (a: Matrix4, b: Matrix4): number =>
  Math.max(...a.elements.map((each, i) => Math.abs(each - b.elements[i])));

test('a rotation in a mirror is that of the mirrored axes', () => {
  const rotation = turn(0.2, 0.5, -0.3, 0.7);
  for (const signs of mirrors) {
    const mirror = new Matrix4().makeScale(signs.x, signs.y, signs.z);
    const seen = mirror.clone().multiply(rotationOf(rotation)).multiply(mirror);
    expect(differenceOf(rotationOf(mirrored(rotation.clone(), signs)), seen)).toBeLessThan(1e-9);
  }
});

test('the rotation in the world and the signs give the matrix in the world, below mirrored parents', () => {
  for (const above of mirrors) {
    for (const own of mirrors) {
      const parent = new Object3D();
      const child = new Object3D();
      parent.quaternion.copy(turn(0.1, -0.6, 0.4, 0.5));
      parent.scale.copy(above);
      child.quaternion.copy(turn(-0.3, 0.2, 0.8, 0.4));
      child.scale.copy(own);
      parent.add(child).updateMatrixWorld();
      const signs = new Vector3();
      const rotation = worldRotation(child, new Quaternion(), signs);
      expect(differenceOf(rotationOf(rotation).scale(signs), child.matrixWorld)).toBeLessThan(1e-9);
    }
  }
});
