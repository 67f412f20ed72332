import type { Placement } from './Placement';
import { PlaceCommand } from './PlaceCommand';

/** Adds GameObjects with everything below them, or removes them. Those that share a parent are in tree order. */
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
