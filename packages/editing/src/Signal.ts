/**
 * Tells its listeners of changes, and counts them. `subscribe` and `revision` are the two arguments of React's
 * `useSyncExternalStore`.
 */
export class Signal {
  private readonly listeners = new Set<() => void>();
  private changes = 0;

  /** Grows by one with each change. */
  get revision(): number {
    return this.changes;
  }

  /** Counts a change and tells the listeners. */
  readonly emit = (): void => {
    this.changes++;
    for (const listener of [...this.listeners]) listener();
  };

  /** Calls `listener` after each change. @returns a function that removes the listener */
  readonly subscribe = (listener: () => void): (() => void) => {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  };
}
