import type { CommandSelection } from '@farol/editing';
import type { Scene } from '@farol/engine';
import { StructuralCommand } from './StructuralCommand';

/** Adds things to the scene, or removes them; undo does the opposite. */
export abstract class PlaceCommand<T> extends StructuralCommand {
  /**
   * @param kind - whether `do` adds or removes
   * @param places - things with their places, in the order to add them
   */
  constructor(
    label: string,
    scene: Scene,
    private readonly kind: 'add' | 'remove',
    private readonly places: readonly T[],
    selection?: CommandSelection,
  ) {
    super(label, scene, selection);
  }

  get isEmpty(): boolean {
    return this.places.length === 0;
  }

  forget(isDone: boolean): void {
    if (isDone !== (this.kind === 'add')) this.places.forEach((place) => this.disposeOf(place));
  }

  protected abstract add(place: T): void;
  protected abstract remove(place: T): void;
  protected abstract disposeOf(place: T): void;

  protected override apply(): void {
    if (this.kind === 'add') this.addAll();
    else this.removeAll();
  }

  protected override revert(): void {
    if (this.kind === 'add') this.removeAll();
    else this.addAll();
  }

  /** Adds all things, or none. @throws the error of adding one */
  private addAll(): void {
    let count = 0;
    try {
      for (; count < this.places.length; count++) this.add(this.places[count]);
    } catch (error) {
      while (count-- > 0) this.remove(this.places[count]);
      throw error;
    }
  }

  private removeAll(): void {
    for (const place of this.places.toReversed()) this.remove(place);
  }
}
