import { replaceOwner } from '@farol/editing';
import { checkFieldValue, type FieldValue } from '@farol/editing/fields';
import type { Component } from './Component';
import type { ComponentClass } from './ComponentClass';
import type { Scene } from './Scene';

type Values = Readonly<Record<string, FieldValue>>;

/** Runs code of a component's class; errors are reported, not thrown. */
function attempt(component: Component, scene: Scene | null, run: () => void): void {
  try {
    run();
  } catch (error) {
    if (scene?.onComponentError) scene.reportError(component, error);
    else console.error(error);
  }
}

/**
 * Replaces a component on a GameObject by a new one of another class, and returns that; id, index and `enabled` are
 * kept. A started component is destroyed first, and the new one starts. `currentOf` maps references to the new one.
 * @param values - field values of the new class, in place of the defaults; values that are not allowed are ignored
 * @throws the error of the class's constructor; nothing has changed then
 */
export function changeClass(before: Component, type: ComponentClass, values: Values): Component {
  const { gameObject, scene, id, enabled } = before;
  const component = new type();
  if (scene) attempt(before, scene, () => scene.componentLeaves(before));
  attempt(before, scene, () => before.detach());
  attempt(before, scene, () => before.dispose());
  for (const [name, value] of Object.entries(values)) if (fits(type, name, value, scene)) component.set(name, value);
  component.enabled = enabled;
  replaceOwner(before, component);
  gameObject.putInPlace(before, component);
  attempt(component, scene, () => component.attachTo(gameObject, id));
  if (!scene) return component;
  attempt(component, scene, () => scene.componentEntered(component));
  scene.notify({ kind: 'component-class', gameObject, before, component });
  return component;
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
