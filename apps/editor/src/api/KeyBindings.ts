import { persist } from 'zustand/middleware';
import { createStore, type StoreApi } from 'zustand';
import { keptInBrowser } from '../model/keptInBrowser';

/** Something with keys of its own: an action. */
interface Keyed {
  readonly id: string;
  readonly keys?: readonly string[];
}

interface KeyState {
  /** Keys that the user has chosen, by id of the action; the others have their own. */
  chosen: Readonly<Record<string, readonly string[]>>;
}

const none: readonly string[] = [];

const sameKeys = (a: readonly string[], b: readonly string[]): boolean => a.join() === b.join();

/** The keys of the actions of one editor as the user has them; kept in the browser. */
export class KeyBindings<T extends Keyed> {
  readonly store: StoreApi<KeyState>;

  /** @param actions - all actions, read when needed @param storage - key in the browser's storage */
  constructor(
    private readonly actions: { readonly list: readonly T[] },
    storage: string,
  ) {
    this.store = createStore<KeyState>()(
      persist((): KeyState => ({ chosen: {} }), { name: storage, storage: keptInBrowser() }),
    );
  }

  /** The combinations that do an action, such as 'Ctrl+Shift+Z'. */
  keysOf(action: T): readonly string[] {
    return this.store.getState().chosen[action.id] ?? action.keys ?? none;
  }

  /** Whether the user has chosen other keys than the action's own. */
  isRebound(action: T): boolean {
    return this.store.getState().chosen[action.id] !== undefined;
  }

  /** Gives an action other keys; null for its own. */
  bind(action: T, keys: readonly string[] | null): void {
    const { [action.id]: _, ...others } = this.store.getState().chosen;
    const isOwn = keys === null || sameKeys(keys, action.keys ?? none);
    this.store.setState({ chosen: isOwn ? others : { ...others, [action.id]: keys } });
  }

  /** Gives every action its own keys again. */
  reset(): void {
    this.store.setState({ chosen: {} });
  }

  /** The other actions that a combination does. */
  conflictsOf(action: T, combination: string): T[] {
    return this.actions.list.filter((other) => other !== action && this.keysOf(other).includes(combination));
  }

  /** Gives an action one more combination, and takes it from whatever else had it. */
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
