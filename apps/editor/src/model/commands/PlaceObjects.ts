import type { Placement } from './Placement';
import { PlaceCommand } from './PlaceCommand';

/** Adds GameObjects with their descendants, or removes them. Siblings are given in tree order. */
export class PlaceObjects extends PlaceCommand<Placement> {
  protected override add({ object, parent, index }: Placement): void {
    parent.add(object, index);
  }

  protected override remove({ object }: Placement): void {
    this.scene.remove(object);
  }

  protected override disposeOf({ object }: Placement): void {
    object.dispose();
  }
}
