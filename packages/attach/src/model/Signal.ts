/** Tells its listeners that something changed. */
export class Signal {
  private readonly listeners = new Set<() => void>();

  /** @returns ends the listening */
  listen(listener: () => void): () => void {
    this.listeners.add(listener);
    return () => this.listeners.delete(listener);
  }

  emit(): void {
    for (const listener of this.listeners) listener();
  }
}
