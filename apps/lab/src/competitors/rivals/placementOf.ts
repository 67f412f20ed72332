import { Matrix4, type Object3D, Quaternion, Vector3 } from 'three';
import type { RivalPlacement } from './RivalScene';

const position = new Vector3();
const rotation = new Quaternion();
const scale = new Vector3();
const again = new Matrix4();

/**
 * World placement of an object, by its `matrixWorld`.
 * @param target - written and returned; a new array by default
 * @throws Error for a sheared object, which a placement cannot describe
 */
export function placementOf(object: Object3D, target: RivalPlacement = new Float32Array(10)): RivalPlacement {
  object.matrixWorld.decompose(position, rotation, scale);
  again.compose(position, rotation, scale);
  const [is, was] = [again.elements, object.matrixWorld.elements];
  const size = Math.max(Math.abs(scale.x), Math.abs(scale.y), Math.abs(scale.z));
  for (let k = 0; k < 12; k++) {
    if (Math.abs(is[k] - was[k]) <= size * 1e-4) continue;
    throw new Error(`${object.name || 'A mesh'} is sheared: the Lab cannot give it to other engines.`);
  }
  position.toArray(target, 0);
  rotation.toArray(target, 3);
  scale.toArray(target, 7);
  return target;
}
