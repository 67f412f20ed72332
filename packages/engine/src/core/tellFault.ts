import { shortText } from '@farol/editing';
import type { Component } from './Component';

/** Tells of a fault of a component that the scene goes on with: to `Scene.onComponentError`, else on the console. */
export function tellFault(component: Component, message: string): void {
  const { scene } = component;
  if (scene?.onComponentError) scene.reportError(component, new Error(message));
  else console.error(`${component.typeName} of '${shortText(component.gameObject.name)}': ${message}`);
}
