import { currentOf } from '@farol/editing';
import type { Component, Scene } from '@farol/engine';
import { StructuralCommand } from './StructuralCommand';

/** A component of an object, and the one that replaces it. */
export interface ComponentSwap {
  readonly before: Component;
  readonly after: Component;
}

/** Replaces components: object, index among its components, id and `enabled` stay. */
export class SwapComponents extends StructuralCommand {
  constructor(
    label: string,
    scene: Scene,
    private readonly swaps: readonly ComponentSwap[],
  ) {
    super(label, scene);
  }

  forget(isDone: boolean): void {
    for (const { before, after } of this.swaps) currentOf(isDone ? before : after).dispose();
  }

  protected override apply(): void {
    for (const { before, after } of this.swaps) swap(before, after);
  }

  protected override revert(): void {
    for (const { before, after } of this.swaps.toReversed()) swap(after, before);
  }
}

function swap(placed: Component, placing: Component): void {
  const [component, other] = [currentOf(placed), currentOf(placing)];
  const { gameObject, id, enabled } = component;
  const index = gameObject.components.indexOf(component);
  gameObject.removeComponent(component);
  other.enabled = enabled;
  gameObject.addComponent(other, {}, { index, id, enabled });
}
