import type { Object3D } from 'three';

/** Where an object hangs: its parent, and its place among the children. */
export class Place {
  /** From 0. */
  readonly index: number;

  constructor(
    readonly object: Object3D,
    private readonly parent: Object3D,
    index = parent.children.indexOf(object),
  ) {
    this.index = index;
  }

  /** Hangs the object there. */
  fill(): void {
    const { object, parent } = this;
    parent.add(object);
    const { children } = parent;
    children.splice(children.indexOf(object), 1);
    children.splice(this.index, 0, object);
  }

  /** Takes the object out. */
  clear(): void {
    this.object.removeFromParent();
  }
}
