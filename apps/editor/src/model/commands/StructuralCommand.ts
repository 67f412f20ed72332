import { type Command, type CommandSelection, currentOf } from '@farol/editing';
import type { CameraComponent, Scene } from '@farol/engine';

/**
 * A command that adds, removes or moves objects or components. A scene that loses its active camera chooses another
 * one; this class makes each `do` and `undo` choose the same one.
 */
export abstract class StructuralCommand implements Command {
  private cameraBefore: CameraComponent | null = null;
  private cameraAfter: CameraComponent | null | undefined;

  constructor(
    readonly label: string,
    protected readonly scene: Scene,
    readonly selection?: CommandSelection,
  ) {}

  do(): void {
    const before = this.scene.activeCamera;
    this.apply();
    this.cameraBefore = before;
    if (this.cameraAfter === undefined) this.cameraAfter = this.scene.activeCamera;
    else this.scene.activeCamera = this.cameraAfter && currentOf(this.cameraAfter);
  }

  undo(): void {
    this.revert();
    this.scene.activeCamera = this.cameraBefore && currentOf(this.cameraBefore);
  }

  /** Makes the change. Must have changed nothing when it throws. */
  protected abstract apply(): void;

  protected abstract revert(): void;
}
