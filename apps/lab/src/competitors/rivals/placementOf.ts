import { Matrix4, type Object3D, Quaternion, Vector3 } from 'three';
import type { RivalPlacement } from './RivalScene';

const position = new Vector3();
const rotation = new Quaternion();
const scale = new Vector3();
const again = new Matrix4();

/**
 * Where an object is in the world, by its `matrixWorld`.
 * @param target - written to; allocates nothing when it is given
 * @throws Error for an object that is sheared: engines have no place for that
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
