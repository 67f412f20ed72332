import { Selection as ItemSelection } from '@farol/editing';

/** The selected GameObjects, by id, in the order in which they were chosen. */
export class Selection extends ItemSelection<string> {
  /** Another array after each change. */
  get ids(): readonly string[] {
    return this.items;
  }
}
