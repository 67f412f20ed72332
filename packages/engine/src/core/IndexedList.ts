/** A list with constant-time add, remove and membership. Removal moves the last entry into the gap. */
export class IndexedList<T> {
  private readonly entries: T[] = [];
  private readonly places = new Map<T, number>();

  /** The entries; the list keeps the same array for life. */
  get array(): readonly T[] {
    return this.entries;
  }

  has(entry: T): boolean {
    return this.places.has(entry);
  }

  /** Adds an entry that is not yet in the list. */
  add(entry: T): void {
    if (this.places.has(entry)) return;
    this.places.set(entry, this.entries.length);
    this.entries.push(entry);
  }

  /** @returns whether the entry was in the list */
  remove(entry: T): boolean {
    const place = this.places.get(entry);
    if (place === undefined) return false;
    const last = this.entries.pop() as T;
    if (last !== entry) {
      this.entries[place] = last;
      this.places.set(last, place);
    }
    this.places.delete(entry);
    return true;
  }
}
