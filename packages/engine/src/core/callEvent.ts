import type { Component } from './Component';

/**
 * Calls a component's event method if present and the component is not switched off; errors go to
 * `Scene.reportError`.
 * @returns whether the component has the method
 */
export function callEvent(component: Component, method: string, ...args: unknown[]): boolean {
  const called = (component as unknown as Readonly<Record<string, unknown>>)[method];
  if (typeof called !== 'function') return false;
  const { scene } = component;
  if (scene?.isSwitchedOff(component)) return true;
  try {
    called.apply(component, args);
  } catch (error) {
    if (!scene) throw error;
    scene.reportError(component, error);
  }
  return true;
}
