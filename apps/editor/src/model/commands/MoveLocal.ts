import { t } from '@farol/editing';
import type { GameObject, Scene } from '@farol/engine';
import { type Container, type Placement, placementOf } from './Placement';
import { StructuralCommand } from './StructuralCommand';

/**
 * Moves a GameObject to the end of another parent with its local transform unchanged, so that its world pose changes.
 */
export class MoveLocal extends StructuralCommand {
  private from: Placement | null = null;

  constructor(
    scene: Scene,
    private readonly object: GameObject,
    private readonly parent: Container,
  ) {
    super(t('Moved {name}', { name: object.name }), scene);
  }

  protected override apply(): void {
    const from = placementOf(this.object, this.scene);
    this.parent.add(this.object);
    this.from = from;
  }

  protected override revert(): void {
    this.from?.parent.add(this.object, this.from.index);
  }
}
