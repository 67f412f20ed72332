/** What a glTF could not take along, counted by kind. */
export class LeftOut {
  private readonly kinds = new Map<string, Set<unknown>>();

  /** @param kind - a sentence without its dot @param thing - counted once; none where there is nothing to count */
  add(kind: string, thing?: unknown): void {
    let things = this.kinds.get(kind);
    if (!things) this.kinds.set(kind, (things = new Set()));
    if (thing !== undefined) things.add(thing);
  }

  /** A line for each kind, with how many there are. */
  get lines(): string[] {
    return [...this.kinds].map(([kind, { size }]) => (size > 0 ? `${kind} (${size.toLocaleString('en')})` : kind));
  }
}
