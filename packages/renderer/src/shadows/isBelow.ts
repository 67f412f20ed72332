import type { Object3D } from 'three';

/** Whether an object is `root` or a descendant of it. */
export function isBelow(object: Object3D, root: Object3D | null): boolean {
  for (let each: Object3D | null = object; each !== null; each = each.parent) if (each === root) return true;
  return false;
}
