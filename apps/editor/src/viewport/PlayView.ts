import { currentOf } from '@farol/editing';
import type { Camera as CameraComponent } from '@farol/engine';
import { Matrix4 } from 'three';
import type { CameraView } from '../model/cameraEdits';
import type { EditorDocument } from '../model/EditorDocument';

const matrix = new Matrix4();
const inverse = new Matrix4();

/** Shows the view of a scene's camera while the scene plays, and restores the view when it stops. */
export class PlayView {
  /** Camera shown before playing, null for the editor's; undefined when there is nothing to restore. */
  private before: CameraComponent | null | undefined;
  /** Camera that the scene plays through; null for none. */
  private camera: CameraComponent | null = null;
  private readonly end: () => void;

  /** Whether the scene is shown as its players see it: while it plays, through the camera that it was started with. */
  get isOn(): boolean {
    const { document, view, camera } = this;
    return camera !== null && view.lookThrough === camera && document.simulation.isPlaying;
  }

  constructor(
    private readonly document: EditorDocument,
    private readonly view: { lookThrough: CameraComponent | null },
  ) {
    this.end = document.simulation.changed.subscribe(() => this.simulationChanged());
  }

  /**
   * Plays the scene through a camera.
   * @param from - pose of the camera while playing, undone by stopping; null for its own
   */
  play(camera: CameraComponent, from: CameraView | null): void {
    const { simulation } = this.document;
    if (simulation.state === 'stopped') this.before = this.view.lookThrough;
    simulation.play();
    if (from) {
      const { object3D } = camera.gameObject;
      const parent = object3D.parent ?? object3D;
      parent.updateWorldMatrix(true, false);
      matrix.compose(from.position, from.quaternion, object3D.scale);
      matrix.premultiply(inverse.copy(parent.matrixWorld).invert());
      object3D.position.setFromMatrixPosition(matrix);
      object3D.quaternion.setFromRotationMatrix(matrix.extractRotation(matrix));
    }
    this.camera = this.view.lookThrough = camera;
  }

  dispose(): void {
    this.end();
  }

  private simulationChanged(): void {
    if (this.document.simulation.state !== 'stopped' || this.before === undefined) return;
    const before = this.before && currentOf(this.before);
    this.before = undefined;
    this.camera = null;
    this.view.lookThrough = before?.isAttached ? before : null;
  }
}
