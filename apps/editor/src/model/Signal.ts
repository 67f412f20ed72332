/** Something that changes, and whoever wants to hear of it. `revision` and `subscribe` are what `useSyncExternalStore` takes. */
export class Signal {
  private readonly listeners = new Set<() => void>();
  private changes = 0;

  /** Grows by one with each change. */
  get revision(): number {
    return this.changes;
  }

  /** How many listen. */
  get listenerCount(): number {
    return this.listeners.size;
  }

  /** Counts a change and tells the listeners. */
  readonly emit = (): void => {
    this.changes++;
    for (const listener of [...this.listeners]) listener();
  };

  /** Calls `listener` after each change. @returns a function that ends it */
  readonly subscribe = (listener: () => void): (() => void) => {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  };
}
