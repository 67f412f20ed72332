import { currentOf } from '@farol/editing';
import type { Component, GameObject } from '@farol/engine';
import { PlaceCommand } from './PlaceCommand';

/** Place of a component: its object and index. */
interface ComponentPlace {
  readonly component: Component;
  readonly object: GameObject;
  /** Index among the object's components. */
  readonly index: number;
  /** Id that the component gets; a new one when absent. */
  readonly id?: string;
}

/** Adds components to GameObjects, or removes them. */
export class PlaceComponents extends PlaceCommand<ComponentPlace> {
  protected override add({ component, object, index, id }: ComponentPlace): void {
    const current = currentOf(component);
    object.addComponent(current, {}, { index, id, enabled: current.enabled });
  }

  protected override remove({ component, object }: ComponentPlace): void {
    object.removeComponent(currentOf(component));
  }

  protected override disposeOf({ component }: ComponentPlace): void {
    currentOf(component).dispose();
  }
}
