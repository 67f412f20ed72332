import type { Command, CommandSelection } from '@farol/editing';
import type { CameraComponent, Scene } from '@farol/engine';

/**
 * A command that adds, takes out or moves. A scene that loses its camera chooses another one: this brings the active
 * camera to the same place after each `do` and each `undo`.
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
    else this.scene.activeCamera = this.cameraAfter;
  }

  undo(): void {
    this.revert();
    this.scene.activeCamera = this.cameraBefore;
  }

  /** Makes the change. What throws must have changed nothing. */
  protected abstract apply(): void;

  /** Takes it back. */
  protected abstract revert(): void;
}
