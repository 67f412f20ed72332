import { labelOfField } from '@farol/editing';
import { type Component, type GameObject, objectAtPath, pathBelow } from '@farol/engine';
import { componentName } from '../componentName';
import { isAnimatable, type TrackAddress } from './clipTracks';

/** The component that a track animates; null when there is none, or it lacks the field. */
export function targetOf(root: GameObject | null, { path, component, field }: TrackAddress): Component | null {
  const target = root && objectAtPath(root, path)?.getComponent(component);
  return target && isAnimatable(target.fields[field]) ? target : null;
}

/**
 * Address of a track for a component's field; null when the field cannot be animated, or its path means another object.
 */
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
  /** Path of the object below the root, such as 'Arm/Cube'. */
  readonly object: string;
  readonly component: string;
  readonly field: string;
}

/** All fields of an object and its descendants that can be animated, in tree order. */
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
