import type { Object3D } from 'three';

/** Words for an object in a message: its type, and its name or that of the next object above it that has one. */
export function describe(object: Object3D): string {
  for (let at: Object3D | null = object; at; at = at.parent) {
    if (at.name) return `${object.type} “${at.name}”`;
  }
  return `${object.type} without a name (${object.uuid})`;
}
