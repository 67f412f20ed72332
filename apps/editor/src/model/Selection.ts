import { Signal } from './Signal';

/** The selected GameObjects, by id, in the order in which they were chosen. */
export class Selection {
  /** Emits when other objects are selected. */
  readonly changed = new Signal();

  private list: readonly string[] = [];

  /** The ids; another array after each change. */
  get ids(): readonly string[] {
    return this.list;
  }

  /** The one chosen last; null when none is. */
  get primary(): string | null {
    return this.list.at(-1) ?? null;
  }

  has(id: string): boolean {
    return this.list.includes(id);
  }

  /** Selects these and no others. */
  set(ids: readonly string[]): void {
    const next = [...new Set(ids)];
    if (next.length === this.list.length && next.every((id, i) => id === this.list[i])) return;
    this.list = Object.freeze(next);
    this.changed.emit();
  }

  /** Selects one more, or one less. */
  toggle(id: string): void {
    this.set(this.has(id) ? this.list.filter((each) => each !== id) : [...this.list, id]);
  }

  clear(): void {
    this.set([]);
  }
}
