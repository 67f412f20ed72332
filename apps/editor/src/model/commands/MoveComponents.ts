import { type Command, currentOf } from '@farol/editing';
import type { Component, GameObject } from '@farol/engine';

interface Move {
  readonly object: GameObject;
  readonly component: Component;
  readonly from: number;
  readonly to: number;
}

/** Moves components up or down among those of their object. */
export class MoveComponents implements Command {
  private readonly moves: readonly Move[];

  /**
   * @param components - one of each object, none of them a Transform
   * @param by - number of places: -1 for up, 1 for down
   */
  constructor(
    readonly label: string,
    components: readonly Component[],
    by: number,
  ) {
    this.moves = components.flatMap((component) => {
      const { gameObject: object } = component;
      const { components: list } = object;
      const from = list.indexOf(component);
      const to = Math.min(Math.max(from + by, 1), list.length - 1);
      return from < 1 || from === to ? [] : [{ object, component, from, to }];
    });
  }

  get isEmpty(): boolean {
    return this.moves.length === 0;
  }

  do(): void {
    for (const { object, component, to } of this.moves) object.moveComponent(currentOf(component), to);
  }

  undo(): void {
    for (const { object, component, from } of this.moves) object.moveComponent(currentOf(component), from);
  }
}
