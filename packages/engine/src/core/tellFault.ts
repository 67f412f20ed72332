import { shortText } from '@farol/editing';
import type { Component } from './Component';

/** Reports a fault to `Scene.onComponentError`, or else on the console; the scene continues. */
export function tellFault(component: Component, message: string): void {
  const { scene } = component;
  if (scene?.onComponentError) scene.reportError(component, new Error(message));
  else console.error(`${component.typeName} of '${shortText(component.gameObject.name)}': ${message}`);
}
