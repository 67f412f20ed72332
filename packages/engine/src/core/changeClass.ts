import { checkFieldValue, type FieldValue } from '@farol/editing/fields';
import { remake } from '../fields/FieldOwner';
import type { Component } from './Component';
import type { ComponentClass } from './ComponentClass';
import type { Scene } from './Scene';

type Values = Readonly<Record<string, FieldValue>>;

/** Runs code of a component's class; errors are reported and stop nothing. */
function attempt(component: Component, scene: Scene | null, run: () => void): void {
  try {
    run();
  } catch (error) {
    if (scene?.onComponentError) scene.reportError(component, error);
    else console.error(error);
  }
}

/**
 * Makes a component that is on a GameObject one of another class: it stays the same object, so that whatever refers to
 * it, such as the history of an editor, goes on. Its id, its place and whether it is enabled stay; what it was besides
 * its fields is as new. A started one is destroyed as of its old class, and starts again as of its new one.
 * @param values - of the fields of the new class, in place of the defaults; those that are not allowed are left out
 * @throws what the constructor of the class throws: make one first, to see whether it can be made
 */
export function changeClass(component: Component, type: ComponentClass, values: Values): void {
  const { gameObject, scene, id, enabled } = component;
  if (scene) attempt(component, scene, () => scene.componentLeaves(component));
  attempt(component, scene, () => component.detach());
  attempt(component, scene, () => component.dispose());
  remake(component, type);
  for (const [name, value] of Object.entries(values)) if (fits(type, name, value, scene)) component.set(name, value);
  component.enabled = enabled;
  attempt(component, scene, () => component.attachTo(gameObject, id));
  if (!scene) return;
  attempt(component, scene, () => scene.componentEntered(component));
  scene.notify({ kind: 'component-class', gameObject, component });
}

/** Whether a field of a class can have a value. A part of a model may be named before the model is loaded. */
export function fits(type: ComponentClass, name: string, value: FieldValue, scene: Scene | null): boolean {
  const field = Object.hasOwn(type.fields, name) ? type.fields[name] : undefined;
  if (!field || checkFieldValue(field, value) !== null) return false;
  if (field.kind !== 'asset' || typeof value !== 'string' || !scene) return true;
  const { assets } = scene;
  if (assets.has(value)) return assets.has(value, field.assetType);
  return assets.list('model').some((model) => value.startsWith(`${model}/`));
}
