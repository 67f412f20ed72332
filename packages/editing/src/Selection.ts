import { Signal } from './Signal';

/** The selected items, each once, in the order in which they were chosen. */
export class Selection<Item> {
  /** Emits when the selection changes. */
  readonly changed = new Signal();

  private list: readonly Item[] = [];
  private members: ReadonlySet<Item> = new Set();

  /** Selected items; a new array after each change. */
  get items(): readonly Item[] {
    return this.list;
  }

  /** The item chosen last; null when none is. */
  get primary(): Item | null {
    return this.list.at(-1) ?? null;
  }

  has(item: Item): boolean {
    return this.members.has(item);
  }

  /** Replaces the selection. */
  set(items: readonly Item[]): void {
    const members = new Set(items);
    const next = [...members];
    if (next.length === this.list.length && next.every((item, i) => item === this.list[i])) return;
    this.list = Object.freeze(next);
    this.members = members;
    this.changed.emit();
  }

  /** Adds an item to the selection, or removes it. */
  toggle(item: Item): void {
    this.set(this.has(item) ? this.list.filter((each) => each !== item) : [...this.list, item]);
  }

  clear(): void {
    this.set([]);
  }
}
