import { Selection as ItemSelection } from '@farol/editing';

/** Ids of the selected GameObjects, in the order they were selected. */
export class Selection extends ItemSelection<string> {
  /** Called at every selection, even when the same objects are selected again. */
  onSet: () => void = () => {};

  /** Ids of the selected objects; a new array after each change. */
  get ids(): readonly string[] {
    return this.items;
  }

  override set(items: readonly string[]): void {
    super.set(items);
    this.onSet();
  }
}
