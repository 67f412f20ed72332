import type { Command, CommandSelection } from '@farol/editing';
import type { Object3D } from 'three';

/** Position in the tree: `index` among the children of `parent`, from 0. */
export interface Placement {
  readonly object: Object3D;
  readonly parent: Object3D;
  readonly index: number;
}

/** Present position of an object in the tree. @param object - must have a parent */
export function placementOf(object: Object3D): Placement {
  const parent = object.parent!;
  return { object, parent, index: parent.children.indexOf(object) };
}

/** Command that adds objects, with their descendants, to the scene, or removes them; each undoes the other. */
export class PlaceObjects implements Command<Object3D> {
  private readonly placements: readonly Placement[];

  /**
   * @param kind - whether `do` adds or removes
   * @param placements - parent and index of each object, counted while all of the objects are in the tree
   */
  constructor(
    readonly label: string,
    private readonly kind: 'add' | 'remove',
    placements: readonly Placement[],
    readonly selection: CommandSelection<Object3D>,
  ) {
    // ascending, since each index counts the siblings inserted before
    this.placements = placements.toSorted((a, b) => a.index - b.index);
  }

  get isEmpty(): boolean {
    return this.placements.length === 0;
  }

  do(): void {
    if (this.kind === 'add') this.add();
    else this.remove();
  }

  undo(): void {
    if (this.kind === 'add') this.remove();
    else this.add();
  }

  private add(): void {
    for (const { object, parent, index } of this.placements) {
      parent.add(object);
      const { children } = parent;
      children.splice(children.indexOf(object), 1);
      children.splice(index, 0, object);
    }
  }

  private remove(): void {
    for (const { object } of this.placements) object.removeFromParent();
  }
}
