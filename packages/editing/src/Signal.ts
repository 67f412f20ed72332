/**
 * Notifies listeners of changes, and counts the changes. `subscribe` and `revision` are the two arguments of React's
 * `useSyncExternalStore`.
 *
 * @typeParam Details - what listeners are told of a change; nothing by default
 */
export class Signal<Details extends readonly unknown[] = []> {
  private readonly listeners = new Set<(...details: Details) => void>();
  private changes = 0;

  /** Number of times that the signal was emitted. */
  get revision(): number {
    return this.changes;
  }

  /** Counts a change and tells the listeners. */
  readonly emit = (...details: Details): void => {
    this.changes++;
    for (const listener of [...this.listeners]) listener(...details);
  };

  /** Calls `listener` after each change. @returns a function that removes the listener */
  readonly subscribe = (listener: (...details: Details) => void): (() => void) => {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  };
}
