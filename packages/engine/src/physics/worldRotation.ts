import { type Object3D, Quaternion, type Vector3 } from 'three';

const localRotation = new Quaternion();

/**
 * The rotation of an object in the world without scale or shear: the product of the rotations from the root down, where
 * those below a mirrored object are mirrored.
 * @param signs - receives the product of the signs of all scales
 */
export function worldRotation(object: Object3D | null, rotation: Quaternion, signs: Vector3): Quaternion {
  if (!object) {
    signs.set(1, 1, 1);
    return rotation.identity();
  }
  worldRotation(object.parent, rotation, signs);
  const { quaternion, scale } = object;
  rotation.multiply(mirrored(localRotation.copy(quaternion), signs));
  if (scale.x < 0) signs.x = -signs.x;
  if (scale.y < 0) signs.y = -signs.y;
  if (scale.z < 0) signs.z = -signs.z;
  return rotation;
}

/** Mirrors a rotation in place, by the signs of a mirroring scale. */
export function mirrored(rotation: Quaternion, signs: Vector3): Quaternion {
  if (signs.x > 0 && signs.y > 0 && signs.z > 0) return rotation;
  const sense = signs.x * signs.y * signs.z;
  return rotation.set(
    rotation.x * signs.x * sense,
    rotation.y * signs.y * sense,
    rotation.z * signs.z * sense,
    rotation.w,
  );
}
