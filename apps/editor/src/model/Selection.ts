import { Selection as ItemSelection } from '@farol/editing';

/** The selected GameObjects, by id, in the order in which they were chosen. */
export class Selection extends ItemSelection<string> {
  /** Called when something is selected, even what was selected before. */
  onSet: () => void = () => {};

  /** Another array after each change. */
  get ids(): readonly string[] {
    return this.items;
  }

  override set(items: readonly string[]): void {
    super.set(items);
    this.onSet();
  }
}
