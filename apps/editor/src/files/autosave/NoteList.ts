/** A set of ids with removal from the end in constant time, whatever its size. */
export class NoteList {
  private readonly known = new Set<string>();
  private readonly order: string[] = [];

  get size(): number {
    return this.known.size;
  }

  add(id: string): this {
    if (!this.known.has(id)) {
      this.known.add(id);
      this.order.push(id);
    }
    return this;
  }

  /** Removes and returns an id; undefined when there is none. */
  take(): string | undefined {
    const id = this.order.pop();
    if (id !== undefined) this.known.delete(id);
    return id;
  }
}
