import type { Component } from '../core/Component';
import type { GameObject } from '../core/GameObject';

/** Whether an object is the root of an instance of a prefab. */
export const isInstanceRoot = (object: GameObject): boolean =>
  object.prefabLink !== null && object.prefabLink.source === object.prefabLink.prefab;

/** Root of the instance to which an object belongs; null for none. */
export function instanceRootOf(object: GameObject): GameObject | null {
  const prefab = object.prefabLink?.prefab;
  if (prefab === undefined) return null;
  for (let above: GameObject | null = object; above; above = above.parent) {
    if (above.prefabLink?.prefab === prefab && isInstanceRoot(above)) return above;
  }
  return null;
}

/** Objects of an instance by their ids in the prefab; objects added to the instance are not included. */
export function objectsBySource(root: GameObject): Map<string, GameObject> {
  const prefab = root.prefabLink!.prefab;
  const found = new Map<string, GameObject>();
  const visit = (object: GameObject): void => {
    const link = object.prefabLink;
    // a nested root of the same prefab begins another instance
    if (object !== root && link?.prefab === prefab && link.source === prefab) return;
    if (link?.prefab === prefab && !found.has(link.source)) found.set(link.source, object);
    object.children.forEach(visit);
  };
  visit(root);
  return found;
}

/** Key of a component within its object, equal in all copies of the object: 'Light', or 'Light2' for a second Light. */
export function componentKey(objectId: string, componentId: string): string {
  return componentId.startsWith(`${objectId}:`) ? componentId.slice(objectId.length + 1) : componentId;
}

/** Name of a component in paths of overrides. */
export const keyOf = (component: Component): string => componentKey(component.gameObject.id, component.id);

/** Paths of values that each instance has for itself: position, rotation and name of its root. */
const instancePaths: ReadonlySet<string> = new Set(['name', 'Transform.position', 'Transform.rotation']);

/** Whether a value belongs to each instance itself and is never an override. @param path - as 'Light.intensity' */
export const isOwnOfInstance = (source: string, prefab: string, path: string): boolean =>
  source === prefab && instancePaths.has(path);
