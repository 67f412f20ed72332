import { labelOfField } from '@farol/editing';
import type { Component, GameObject } from '@farol/engine';
import { componentName } from '../componentName';
import { isAnimatable, type TrackAddress } from './clipTracks';

/** The names from below an object down to one below it, as tracks have them; null for one that is not below it. */
export function pathBetween(root: GameObject, object: GameObject): string | null {
  const names: string[] = [];
  let at: GameObject | null = object;
  for (; at && at !== root; at = at.parent) names.unshift(at.name);
  return at ? names.join('/') : null;
}

/** The object at a path below another: of children of one name the first. Null when there is none. */
export function objectAt(root: GameObject, path: string): GameObject | null {
  if (path === '') return root;
  for (const child of root.children) {
    if (child.name === path) return child;
    // names may hold slashes
    if (!path.startsWith(`${child.name}/`)) continue;
    const found = objectAt(child, path.slice(child.name.length + 1));
    if (found) return found;
  }
  return null;
}

/** The component that a track changes; null when it is gone, or has no such field. */
export function targetOf(root: GameObject | null, { path, component, field }: TrackAddress): Component | null {
  const target = root && objectAt(root, path)?.getComponent(component);
  return target && isAnimatable(target.fields[field]) ? target : null;
}

/** What a track of a field of a component would be of; null where none can be, or another object is found by the path. */
export function addressOf(root: GameObject, component: Component, field: string): TrackAddress | null {
  if (!component.isAttached || !isAnimatable(component.fields[field])) return null;
  const { gameObject, typeName } = component;
  const path = pathBetween(root, gameObject);
  if (path === null || objectAt(root, path)?.getComponent(typeName) !== component) return null;
  return { path, component: typeName, field };
}

/** A field that a track can be added for. */
export interface AnimatableField {
  readonly address: TrackAddress;
  /** 'Cube', with the names above it but the root's. */
  readonly object: string;
  readonly component: string;
  readonly field: string;
}

/** Every field of an object and of all below it that tracks may be of, in the order of the tree. */
export function animatableFields(root: GameObject): AnimatableField[] {
  const list: AnimatableField[] = [];
  root.traverse((object) => {
    for (const component of object.components) {
      for (const field of Object.keys(component.fields)) {
        const address = addressOf(root, component, field);
        if (!address) continue;
        list.push({
          address,
          object: address.path === '' ? root.name : address.path.replaceAll('/', ' / '),
          component: componentName(component.typeName),
          field: labelOfField(field, component.fields[field]),
        });
      }
    }
  });
  return list;
}
