import { create } from 'zustand';
import { persist } from 'zustand/middleware';
import type { Action } from './Action';
import { actions } from './index';

interface KeyBindings {
  /** Keys that the user has chosen, by id of the action; the others have their own. */
  chosen: Readonly<Record<string, readonly string[]>>;
}

/** The keys of the actions as the user has them; kept in the browser. */
export const useKeyBindings = create<KeyBindings>()(
  persist((): KeyBindings => ({ chosen: {} }), { name: 'farol-editor-keys' }),
);

const none: readonly string[] = [];

/** The combinations that do an action, such as 'Ctrl+Shift+Z'. */
export function keysOf(action: Action): readonly string[] {
  return useKeyBindings.getState().chosen[action.id] ?? action.keys ?? none;
}

/** Whether the user has chosen other keys than the action's own. */
export const isRebound = (action: Action): boolean => useKeyBindings.getState().chosen[action.id] !== undefined;

const sameKeys = (a: readonly string[], b: readonly string[]): boolean => a.join() === b.join();

/** Gives an action other keys; null for its own. */
export function bindKeys(action: Action, keys: readonly string[] | null): void {
  const { [action.id]: _, ...others } = useKeyBindings.getState().chosen;
  const isOwn = keys === null || sameKeys(keys, action.keys ?? none);
  useKeyBindings.setState({ chosen: isOwn ? others : { ...others, [action.id]: keys } });
}

/** Gives every action its own keys again. */
export function resetKeys(): void {
  useKeyBindings.setState({ chosen: {} });
}

/** The other actions that a combination does. */
export function conflictsOf(action: Action, combination: string): Action[] {
  return actions.list.filter((other) => other !== action && keysOf(other).includes(combination));
}

/** Gives an action one more combination, and takes it from whatever else had it. */
export function takeKey(action: Action, combination: string): void {
  for (const other of conflictsOf(action, combination)) {
    bindKeys(
      other,
      keysOf(other).filter((keys) => keys !== combination),
    );
  }
  if (!keysOf(action).includes(combination)) bindKeys(action, [...keysOf(action), combination]);
}
