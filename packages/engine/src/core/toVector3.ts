import type { Vector3Tuple } from '@farol/editing/fields';
import type { Vector3, Vector3Like } from 'three';

/** A point or direction: [x, y, z], or anything with x, y and z. */
export type Vector3Input = Vector3Tuple | Vector3Like;

/** Copies a point or direction into `target`. */
export function toVector3(value: Vector3Input, target: Vector3): Vector3 {
  return 'x' in value ? target.set(value.x, value.y, value.z) : target.set(value[0], value[1], value[2]);
}
