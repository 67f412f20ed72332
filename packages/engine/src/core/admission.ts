import { shortText } from '@farol/editing';
import { assetFields } from '../fields/assetFields';
import type { Component } from './Component';
import type { GameObject } from './GameObject';
import type { Scene } from './Scene';

/**
 * Checks that an object, with its descendants, may be added to a scene.
 * @throws Error naming a duplicate id or an unknown asset
 */
export function checkSubtree(scene: Scene, gameObject: GameObject): void {
  gameObject.traverse((each) => {
    if (scene.findById(each.id)) {
      throw new Error(
        `The scene has an object with the id '${shortText(each.id)}' ('${shortText(each.name)}') already: clone() it instead.`,
      );
    }
    for (const component of each.components) checkComponent(scene, component);
  });
}

/** Checks that a component may be added to a scene. @throws Error when the component names an unknown asset */
export function checkComponent(scene: Scene, component: Component): void {
  for (const { name, assetType } of assetFields(component.fields)) {
    const value = component.getAuthored(name);
    const problem = typeof value === 'string' && scene.assets.problemWith(assetType, value);
    if (problem) throw new Error(`${component.typeName}.${name} ${problem}`);
  }
}
