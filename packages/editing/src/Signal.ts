/**
 * Notifies listeners of changes, and counts the changes. `subscribe` and `revision` are the two arguments of React's
 * `useSyncExternalStore`.
 *
 * @typeParam Details - arguments of listeners; none by default
 */
export class Signal<Details extends readonly unknown[] = []> {
  private readonly listeners = new Set<(...details: Details) => void>();
  /** `listeners` as an array, which stays unchanged during an emit; null after a change of `listeners`. */
  private snapshot: readonly ((...details: Details) => void)[] | null = null;
  private changes = 0;

  /** Number of times that the signal was emitted. */
  get revision(): number {
    return this.changes;
  }

  /** Counts a change and calls the listeners. */
  readonly emit = (...details: Details): void => {
    this.changes++;
    const told = (this.snapshot ??= [...this.listeners]);
    for (let i = 0; i < told.length; i++) told[i](...details);
  };

  /** Calls `listener` after each change. @returns a function that removes the listener */
  readonly subscribe = (listener: (...details: Details) => void): (() => void) => {
    this.listeners.add(listener);
    this.snapshot = null;
    return () => {
      this.snapshot = null;
      this.listeners.delete(listener);
    };
  };
}
