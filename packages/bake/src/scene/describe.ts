import type { Object3D } from 'three';

/** Describes an object in messages: its type, and its name or that of its nearest named ancestor. */
export function describe(object: Object3D): string {
  for (let at: Object3D | null = object; at; at = at.parent) {
    if (at.name) return `${object.type} “${at.name}”`;
  }
  return `${object.type} without a name (${object.uuid})`;
}
