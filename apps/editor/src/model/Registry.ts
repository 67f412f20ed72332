import { Signal } from '@farol/editing';

/** Items of one editor known by id, such as its actions or panels: built-in ones, and those of plugins. */
export class Registry<T extends { readonly id: string }> {
  /** Emits when an item is added or removed. */
  readonly changed = new Signal();

  private items: readonly T[] = [];

  /**
   * @param noun - an item's name in messages, with its article: 'an action'
   * @param items - items from the start
   * @throws Error when two of them have the same id
   */
  constructor(
    private readonly noun: string,
    items: readonly T[],
  ) {
    for (const item of items) this.add(item);
  }

  /** All items, in the order they were added; a new array after each change. */
  get list(): readonly T[] {
    return this.items;
  }

  get(id: string): T | undefined {
    return this.items.find((item) => item.id === id);
  }

  /** Adds an item. @returns a function that removes the item @throws Error when the id is taken */
  add(item: T): () => void {
    if (this.get(item.id)) throw new Error(`There is ${this.noun} '${item.id}' already: choose another id.`);
    this.items = [...this.items, item];
    this.changed.emit();
    return () => {
      if (!this.items.includes(item)) return;
      this.items = this.items.filter((each) => each !== item);
      this.changed.emit();
    };
  }
}
