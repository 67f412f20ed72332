import type { CommandSelection } from '@farol/editing';
import type { Scene } from '@farol/engine';
import type { Placement } from './Placement';
import { StructuralCommand } from './StructuralCommand';

/** Adds GameObjects with everything below them, or removes them; undoing one is doing the other. */
export class PlaceObjects extends StructuralCommand {
  /**
   * @param kind - whether `do` adds or removes
   * @param placements - in the order to add them: tree order where they share a parent
   */
  constructor(
    label: string,
    scene: Scene,
    private readonly kind: 'add' | 'remove',
    private readonly placements: readonly Placement[],
    selection: CommandSelection,
  ) {
    super(label, scene, selection);
  }

  get isEmpty(): boolean {
    return this.placements.length === 0;
  }

  forget(isDone: boolean): void {
    if (isDone === (this.kind === 'add')) return;
    for (const { object } of this.placements) object.dispose();
  }

  protected override apply(): void {
    if (this.kind === 'add') this.add();
    else this.remove();
  }

  protected override revert(): void {
    if (this.kind === 'add') this.remove();
    else this.add();
  }

  private add(): void {
    let count = 0;
    try {
      for (; count < this.placements.length; count++) {
        const { object, parent, index } = this.placements[count];
        parent.add(object, index);
      }
    } catch (error) {
      while (count-- > 0) this.scene.remove(this.placements[count].object);
      throw error;
    }
  }

  private remove(): void {
    for (const { object } of this.placements.toReversed()) this.scene.remove(object);
  }
}
