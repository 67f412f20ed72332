import { Matrix4, PerspectiveCamera, Vector3 } from 'three';
import { expect, it } from 'vitest';
import { setUnionCamera } from './unionCamera';

/** An eye of a headset, its frustum by the tangents left, right, bottom and top. */
function eyeOf(x: number, turn: number, [left, right, bottom, top]: readonly number[]): PerspectiveCamera {
  const eye = new PerspectiveCamera();
  eye.matrixWorld
    .makeRotationY(0.7)
    .setPosition(3, 1.6, -2)
    .multiply(new Matrix4().makeTranslation(x, 0, 0))
    .multiply(new Matrix4().makeRotationY(turn));
  eye.matrixWorldInverse.copy(eye.matrixWorld).invert();
  eye.projectionMatrix.makePerspective(0.1 * left, 0.1 * right, 0.1 * top, 0.1 * bottom, 0.1, 50);
  eye.projectionMatrixInverse.copy(eye.projectionMatrix).invert();
  return eye;
}

const first = eyeOf(-0.032, 0, [-1.2, 0.9, -1, 0.8]);
const second = eyeOf(0.032, 0, [-0.9, 1.3, -0.9, 0.9]);

it('sees all that either eye sees', () => {
  const camera = new PerspectiveCamera();
  expect(setUnionCamera(camera, [first, second])).toBe(true);
  for (const eye of [first, second])
    for (const x of [-1, -0.3, 1])
      for (const y of [-1, 0.2, 1])
        for (const z of [-1, 0, 0.9, 1]) {
          const point = new Vector3(x, y, z).applyMatrix4(eye.projectionMatrixInverse).applyMatrix4(eye.matrixWorld);
          point.applyMatrix4(camera.matrixWorldInverse).applyMatrix4(camera.projectionMatrix);
          for (const value of point) expect(Math.abs(value)).toBeLessThan(1 + 1e-4);
        }
});

it('is refused for eyes that are turned to each other', () => {
  expect(setUnionCamera(new PerspectiveCamera(), [first, eyeOf(0.032, 0.05, [-1, 1, -1, 1])])).toBe(false);
});
