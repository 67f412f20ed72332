import { currentOf } from '@farol/editing';
import type { Component, GameObject, Scene } from '@farol/engine';
import { StructuralCommand } from './StructuralCommand';

/** Adds components to GameObjects, or removes them; undoing one is doing the other. */
export class PlaceComponents extends StructuralCommand {
  /**
   * @param kind - whether `do` adds or removes
   * @param places - component, its object, its index in the object's list, and the id for a new one
   */
  constructor(
    label: string,
    scene: Scene,
    private readonly kind: 'add' | 'remove',
    private readonly places: readonly { component: Component; object: GameObject; index: number; id?: string }[],
  ) {
    super(label, scene);
  }

  get isEmpty(): boolean {
    return this.places.length === 0;
  }

  forget(isDone: boolean): void {
    if (isDone === (this.kind === 'add')) return;
    for (const { component } of this.places) currentOf(component).dispose();
  }

  protected override apply(): void {
    if (this.kind === 'add') this.add();
    else this.remove();
  }

  protected override revert(): void {
    if (this.kind === 'add') this.remove();
    else this.add();
  }

  private add(): void {
    let count = 0;
    try {
      for (; count < this.places.length; count++) {
        const { object, index, id } = this.places[count];
        const component = currentOf(this.places[count].component);
        object.addComponent(component, {}, { index, id, enabled: component.enabled });
      }
    } catch (error) {
      while (count-- > 0) this.places[count].object.removeComponent(currentOf(this.places[count].component));
      throw error;
    }
  }

  private remove(): void {
    for (const { component, object } of this.places.toReversed()) object.removeComponent(currentOf(component));
  }
}
