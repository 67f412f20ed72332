import { Matrix4, type PerspectiveCamera } from 'three';
import { projectionFar, projectionNear } from '../../lights/projection';

/** Largest difference between the eyes' axes; eyes turned towards each other have no common frustum. */
const PARALLEL = 1e-5;
const relative = new Matrix4();

/**
 * Places a camera behind two eyes, so that its frustum holds both of theirs.
 * @returns whether there is such a frustum: the eyes look the same way, by perspective
 */
export function setUnionCamera(camera: PerspectiveCamera, [first, second]: readonly PerspectiveCamera[]): boolean {
  relative.multiplyMatrices(first.matrixWorldInverse, second.matrixWorld);
  const m = relative.elements;
  for (let i = 0; i < 12; i++) if (Math.abs(m[i] - (i % 5 === 0 ? 1 : 0)) > PARALLEL) return false;
  const p = first.projectionMatrix.elements;
  const q = second.projectionMatrix.elements;
  if (p[11] !== -1 || q[11] !== -1) return false;
  // tangents of the angles of the common frustum's sides
  const left = Math.min((p[8] - 1) / p[0], (q[8] - 1) / q[0]);
  const right = Math.max((p[8] + 1) / p[0], (q[8] + 1) / q[0]);
  const bottom = Math.min((p[9] - 1) / p[5], (q[9] - 1) / q[5]);
  const top = Math.max((p[9] + 1) / p[5], (q[9] + 1) / q[5]);
  if (!(left < 0 && right > 0 && bottom < 0 && top > 0)) return false;
  const back = Math.max(Math.abs(m[12]) / (right - left), Math.abs(m[13]) / (top - bottom));
  const x = Math.min(0, m[12]) - left * back;
  const y = Math.min(0, m[13]) - bottom * back;
  const z = Math.max(0, m[14]) + back;
  const near = Math.min(projectionNear(p), projectionNear(q)) + back;
  const far = Math.max(projectionFar(p), projectionFar(q)) + back + Math.abs(m[14]);
  camera.near = near;
  camera.far = far;
  camera.matrixWorld.makeTranslation(x, y, z).premultiply(first.matrixWorld);
  camera.matrixWorldInverse.copy(camera.matrixWorld).invert();
  camera.projectionMatrix.makePerspective(left * near, right * near, top * near, bottom * near, near, far);
  camera.projectionMatrixInverse.copy(camera.projectionMatrix).invert();
  return true;
}
