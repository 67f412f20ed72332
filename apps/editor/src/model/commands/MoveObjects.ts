import type { GameObject, Scene } from '@farol/engine';
import type { FieldValue } from '@farol/engine/fields';
import { childrenOf, type Container, type Placement, placementOf } from './Placement';
import { StructuralCommand } from './StructuralCommand';

type Values = Readonly<Record<string, FieldValue>>;

interface Move {
  readonly from: Placement;
  readonly to: Placement;
  /** Authored values of the Transform before the move. */
  readonly before: Values;
  readonly after: Values;
}

function place({ object, parent, index }: Placement, values: Values): void {
  object.reparent(parent, index, { keepWorld: false });
  for (const name of Object.keys(values)) object.transform.set(name, values[name]);
}

/** Moves GameObjects in the tree; their world poses stay when the parent changes. */
export class MoveObjects extends StructuralCommand {
  private moves: readonly Move[] | null = null;

  /**
   * @param objects - objects to move; none of them is below another
   * @param parent - new parent, which is neither one of the objects nor below one
   * @param before - child of `parent`, not one of the objects, that they are put before; null for the end
   */
  constructor(
    label: string,
    scene: Scene,
    private readonly objects: readonly GameObject[],
    private readonly parent: Container,
    private readonly before: GameObject | null,
  ) {
    super(label, scene);
  }

  /** Whether all objects are at their new places already. */
  get isEmpty(): boolean {
    if (this.moves) return false;
    const siblings = childrenOf(this.parent);
    const end = this.before ? siblings.indexOf(this.before) : siblings.length;
    const first = end - this.objects.length;
    return this.objects.every((object, i) => siblings[first + i] === object);
  }

  /** @throws Error when the new parent is one of the objects or below one; nothing has changed then */
  protected override apply(): void {
    if (this.moves) for (const { to, after } of this.moves) place(to, after);
    else this.moves = this.moveFirst();
  }

  protected override revert(): void {
    for (const { from, before } of (this.moves ?? []).toReversed()) place(from, before);
  }

  private moveFirst(): Move[] {
    const moves: Move[] = [];
    try {
      for (const object of this.objects) moves.push(this.moveOne(object));
    } catch (error) {
      for (const { from, before } of moves.toReversed()) place(from, before);
      throw error;
    }
    return moves;
  }

  private moveOne(object: GameObject): Move {
    const from = placementOf(object, this.scene);
    const before = object.transform.authoredValues();
    const siblings = childrenOf(this.parent);
    const isSibling = from.parent === this.parent;
    let index = this.before ? siblings.indexOf(this.before) : siblings.length;
    if (isSibling && from.index < index) index--;
    object.reparent(this.parent, index, { keepWorld: !isSibling });
    return { from, to: { object, parent: this.parent, index }, before, after: object.transform.authoredValues() };
  }
}
