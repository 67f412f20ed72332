import type { Command } from '@farol/editing';
import type { Component } from '@farol/engine';

interface Move {
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
      const { components: list } = component.gameObject;
      const from = list.indexOf(component);
      const to = Math.min(Math.max(from + by, 1), list.length - 1);
      return from < 1 || from === to ? [] : [{ component, from, to }];
    });
  }

  get isEmpty(): boolean {
    return this.moves.length === 0;
  }

  do(): void {
    for (const { component, to } of this.moves) component.gameObject.moveComponent(component, to);
  }

  undo(): void {
    for (const { component, from } of this.moves) component.gameObject.moveComponent(component, from);
  }
}
