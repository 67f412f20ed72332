import { Signal } from '../model/Signal';
import type { Action } from './Action';

/** The actions that there are: the editor's own (`actions/index.ts`), and what plugins add. */
export class ActionRegistry {
  /** Emits when an action comes or goes. */
  readonly changed = new Signal();

  private actions: readonly Action[] = [];

  /** @throws Error when two have the same id */
  constructor(actions: readonly Action[]) {
    for (const action of actions) this.add(action);
  }

  /** Another array after each change. */
  get list(): readonly Action[] {
    return this.actions;
  }

  get(id: string): Action | undefined {
    return this.actions.find((action) => action.id === id);
  }

  /** Adds an action. @returns a function that takes it out. @throws Error when the id is taken */
  add(action: Action): () => void {
    if (this.get(action.id)) throw new Error(`There is an action '${action.id}' already: choose another id.`);
    this.actions = [...this.actions, action];
    this.changed.emit();
    return () => {
      this.actions = this.actions.filter((each) => each !== action);
      this.changed.emit();
    };
  }
}
