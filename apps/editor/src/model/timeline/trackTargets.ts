import { labelOfField } from '@farol/editing';
import { type Component, type GameObject, objectAtPath, pathBelow } from '@farol/engine';
import { componentName } from '../componentName';
import { isAnimatable, type TrackAddress } from './clipTracks';

/** The component that a track changes; null when it is gone, or has no such field. */
export function targetOf(root: GameObject | null, { path, component, field }: TrackAddress): Component | null {
  const target = root && objectAtPath(root, path)?.getComponent(component);
  return target && isAnimatable(target.fields[field]) ? target : null;
}

/** What a track of a field of a component would be of; null where none can be, or another object is found by the path. */
export function addressOf(root: GameObject, component: Component, field: string): TrackAddress | null {
  if (!component.isAttached || !isAnimatable(component.fields[field])) return null;
  const { gameObject, typeName } = component;
  const path = pathBelow(root, gameObject);
  if (path === null || gameObject.getComponent(typeName) !== component) return null;
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
