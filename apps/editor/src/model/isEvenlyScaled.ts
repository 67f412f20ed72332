import type { GameObject } from '@farol/engine';
import { Vector3 } from 'three';

/** Tolerance for rounding of a parent's axes: relative difference of lengths, and cosines between them. */
const EVEN = 1e-4;

const axes = [new Vector3(), new Vector3(), new Vector3()] as const;

/** Whether the world matrix of an object keeps angles: uniform scale, no mirroring, no shear. */
export function isEvenlyScaled(object: GameObject): boolean {
  object.object3D.updateWorldMatrix(true, false);
  const { matrixWorld } = object.object3D;
  matrixWorld.extractBasis(...axes);
  const lengths = axes.map((axis) => axis.length());
  for (const axis of axes) axis.normalize();
  const [x, y, z] = axes;
  const skew = Math.max(Math.abs(x.dot(y)), Math.abs(y.dot(z)), Math.abs(z.dot(x)));
  const isEven = Math.max(...lengths) - Math.min(...lengths) <= EVEN * Math.max(...lengths);
  return isEven && skew <= EVEN && matrixWorld.determinant() > 0;
}
