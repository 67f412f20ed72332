import { Camera as CameraComponent } from '@farol/engine';
import { type Camera, Vector2 } from 'three';
import type { EditorDocument } from '../model/EditorDocument';
import { boundsOf } from './boundsOf';
import type { EditorCamera } from './EditorCamera';
import { hitPoint } from './pick';

const middle = new Vector2();

/** The camera of the picture: the editor's own, or one of the scene that is looked through. */
export class PictureCamera {
  private through: CameraComponent | null = null;

  constructor(
    private readonly document: EditorDocument,
    private readonly own: EditorCamera,
  ) {}

  /** The camera of the scene that is looked through; null for the editor's own. */
  get lookThrough(): CameraComponent | null {
    return this.through;
  }

  set lookThrough(camera: CameraComponent | null) {
    this.through = camera;
    this.own.enabled = camera === null;
  }

  /** Whether a camera is looked through that has been taken out of the scene. */
  get isLost(): boolean {
    return this.through !== null && !this.document.scene.componentsOf(CameraComponent).includes(this.through);
  }

  get current(): Camera {
    return this.through?.isAttached ? this.through.three : this.own.camera;
  }

  /** The selected camera, unless it is looked through; null when none is selected. */
  get selected(): CameraComponent | null {
    const camera = this.document.selectedObjects.at(-1)?.getComponent(CameraComponent) ?? null;
    return camera === this.through ? null : camera;
  }

  /** Brings the editor's own camera to where a scene that was just opened is seen from. */
  showScene(): void {
    const { scene } = this.document;
    const { activeCamera } = scene;
    scene.three.updateMatrixWorld();
    if (!activeCamera) return this.own.focus(boundsOf(scene.roots), false);
    this.own.matchCamera(activeCamera, (camera) => hitPoint(scene, camera, middle)?.distance ?? null);
  }

  /** Looks at the selection, or at everything. */
  focus(): void {
    const { selectedObjects, scene } = this.document;
    const box = boundsOf(selectedObjects.length > 0 ? selectedObjects : scene.roots);
    if (!box.isEmpty()) this.own.focus(box);
  }
}
