/** Ids that wait, each once; taken from the end, which costs the same however many there were. */
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

  /** Takes one out; undefined when none waits. */
  take(): string | undefined {
    const id = this.order.pop();
    if (id !== undefined) this.known.delete(id);
    return id;
  }
}
