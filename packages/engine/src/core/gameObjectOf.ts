import type { Object3D } from 'three';
import type { GameObject } from './GameObject';

const owners = new WeakMap<Object3D, GameObject>();

/** @internal Called by GameObject for its own object3D. */
export function setGameObjectOf(object3D: Object3D, gameObject: GameObject): void {
  owners.set(object3D, gameObject);
}

/** Owner of a three object that draws many GameObjects as instances. */
export interface InstanceOwner {
  gameObjectAt(instanceId: number): GameObject | null;
}

/**
 * The GameObject of a three object, such as a mesh hit by a ray, or of its nearest ancestor.
 * @param instanceId - `intersection.instanceId`, for objects that are drawn as instances
 */
export function gameObjectOf(object3D: Object3D | null, instanceId?: number): GameObject | null {
  if (instanceId !== undefined && object3D && 'gameObjectAt' in object3D) {
    return (object3D as unknown as InstanceOwner).gameObjectAt(instanceId);
  }
  for (let object = object3D; object; object = object.parent) {
    const owner = owners.get(object);
    if (owner) return owner;
  }
  return null;
}
