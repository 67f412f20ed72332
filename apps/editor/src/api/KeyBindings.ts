import { persist } from 'zustand/middleware';
import { createStore, type StoreApi } from 'zustand';
import { keptInBrowser } from '../model/keptInBrowser';

/** An action, as far as keys are concerned. */
interface Keyed {
  readonly id: string;
  readonly keys?: readonly string[];
}

interface KeyState {
  /** Keys that the user has changed, by id of the action; other actions have their default keys. */
  chosen: Readonly<Record<string, readonly string[]>>;
}

const none: readonly string[] = [];

const sameKeys = (a: readonly string[], b: readonly string[]): boolean => a.join() === b.join();

/** The user's key bindings for the actions of one editor, stored in the browser. */
export class KeyBindings<T extends Keyed> {
  readonly store: StoreApi<KeyState>;

  /** @param actions - all actions, read when needed @param storage - key in localStorage */
  constructor(
    private readonly actions: { readonly list: readonly T[] },
    storage: string,
  ) {
    this.store = createStore<KeyState>()(
      persist((): KeyState => ({ chosen: {} }), { name: storage, storage: keptInBrowser() }),
    );
  }

  /** The combinations of an action, such as 'Ctrl+Shift+Z'. */
  keysOf(action: T): readonly string[] {
    return this.store.getState().chosen[action.id] ?? action.keys ?? none;
  }

  /** Whether the user has changed the action's keys. */
  isRebound(action: T): boolean {
    return this.store.getState().chosen[action.id] !== undefined;
  }

  /** Changes an action's keys; null restores its defaults. */
  bind(action: T, keys: readonly string[] | null): void {
    const { [action.id]: _, ...others } = this.store.getState().chosen;
    const isOwn = keys === null || sameKeys(keys, action.keys ?? none);
    this.store.setState({ chosen: isOwn ? others : { ...others, [action.id]: keys } });
  }

  /** Restores the default keys of every action. */
  reset(): void {
    this.store.setState({ chosen: {} });
  }

  /** Other actions that have the same key combination. */
  conflictsOf(action: T, combination: string): T[] {
    return this.actions.list.filter((other) => other !== action && this.keysOf(other).includes(combination));
  }

  /** Adds a combination to an action, removing it from other actions. */
  take(action: T, combination: string): void {
    for (const other of this.conflictsOf(action, combination)) {
      this.bind(
        other,
        this.keysOf(other).filter((keys) => keys !== combination),
      );
    }
    if (!this.keysOf(action).includes(combination)) this.bind(action, [...this.keysOf(action), combination]);
  }
}
