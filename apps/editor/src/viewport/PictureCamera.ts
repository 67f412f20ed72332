import { currentOf } from '@farol/editing';
import { Camera as CameraComponent, type CameraComponent as AnyCamera, hitPoint } from '@farol/engine';
import { type Camera, MathUtils, Sphere, Vector2, Vector3 } from 'three';
import type { CameraView } from '../model/cameraEdits';
import type { EditorDocument } from '../model/EditorDocument';
import { boundsOf } from './boundsOf';
import type { CameraFlight } from './CameraFlight';
import type { EditorCamera } from './EditorCamera';
import { LatePart } from './LatePart';
import type { ViewPose } from './ViewPose';
import { castByTree } from './trees/castByTree';

const middle = new Vector2();

/** The camera that the viewport shows: the editor's own, or one of the scene. */
export class PictureCamera {
  /** Code that moves a camera of the scene; fetched once the viewport shows one. */
  private readonly flight: LatePart<CameraFlight>;
  private through: CameraComponent | null = null;
  /** Pose of the editor's camera before the view of a scene's camera was shown. */
  private before: ViewPose | null = null;

  /** @param failed - called when the code that moves a camera of the scene cannot be fetched */
  constructor(
    private readonly document: EditorDocument,
    private readonly editorCamera: EditorCamera,
    canvas: HTMLCanvasElement,
    failed: (error: unknown) => void,
  ) {
    this.flight = new LatePart(
      () => this.through !== null,
      async () => {
        const { CameraFlight: Flight } = await import('./CameraFlight');
        return () => {
          const flight = new Flight(document, editorCamera, canvas, (camera) => this.match(camera, true));
          flight.camera = this.through;
          return flight;
        };
      },
      failed,
    );
  }

  /** The scene's camera whose view is shown; null for the editor's own. */
  get lookThrough(): CameraComponent | null {
    return this.through;
  }

  set lookThrough(camera: CameraComponent | null) {
    if (camera === this.through) return;
    if (this.through === null) this.before = this.editorCamera.pose;
    this.through = camera;
    const flight = this.flight.get();
    if (flight) flight.camera = camera;
    if (camera === null && this.before) this.editorCamera.show(this.before, false);
    this.editorCamera.allowed = this.steers;
  }

  /** Whether the controls can change the view: true for the editor's camera; a scene's camera must be movable. */
  get steers(): boolean {
    return this.through === null || (this.flight.part !== null && this.problem === null);
  }

  /** Why the shown camera cannot be moved, in a sentence with the remedy; null when it can. */
  get problem(): string | null {
    return this.flight.part?.problem ?? null;
  }

  /** Whether the shown camera has been removed from the scene. */
  get isLost(): boolean {
    if (this.through === null) return false;
    // an edited script may have replaced the camera
    this.lookThrough = currentOf(this.through);
    return !this.document.scene.componentsOf(CameraComponent).includes(this.through);
  }

  get current(): Camera {
    return this.through?.isAttached ? this.through.three : this.editorCamera.camera;
  }

  /** Camera for raycasting: same view as `current`, with rays that start far enough back to hit everything visible. */
  get rays(): Camera {
    return this.through?.isAttached ? this.through.three : this.editorCamera.rayCamera;
  }

  /** Advances the camera's movement. @returns whether the view changed */
  update(deltaSeconds: number): boolean {
    this.editorCamera.allowed = this.steers;
    const flight = this.flight.part;
    flight?.follow();
    const hasMoved = this.editorCamera.update(deltaSeconds);
    flight?.update(hasMoved);
    return hasMoved;
  }

  /** The selected camera; null when none is selected, or when the viewport shows its view already. */
  get selected(): CameraComponent | null {
    const camera = this.document.selectedObjects.at(-1)?.getComponent(CameraComponent) ?? null;
    return camera === this.through ? null : camera;
  }

  /** Moves the editor's camera to the initial view of a scene that was just opened. */
  showScene(): void {
    const { scene } = this.document;
    const { activeCamera } = scene;
    scene.three.updateMatrixWorld();
    this.before = null;
    if (!activeCamera) return this.editorCamera.focus(boundsOf(scene.roots), false);
    this.match(activeCamera);
  }

  /** Moves the editor's camera to a camera of the scene. @param exact - see `EditorCamera.matchCamera` */
  match(camera: AnyCamera, exact = false): void {
    const { scene } = this.document;
    this.editorCamera.matchCamera(
      camera,
      (three) => hitPoint(scene, three, middle, undefined, castByTree)?.distance ?? null,
      exact,
    );
  }

  /** Pose and lens of the editor's camera. */
  get view(): CameraView {
    const { perspective, orthographic, height, target } = this.editorCamera;
    const { position, quaternion } = perspective;
    const fov = perspective.fov * MathUtils.DEG2RAD;
    if (!orthographic) return { position, quaternion, fov, size: null, far: 0 };
    // the eye is moved back until the whole scene is in front of it
    const sphere = boundsOf(this.document.scene.roots).getBoundingSphere(new Sphere());
    const back = sphere.isEmpty() ? 0 : sphere.center.distanceTo(target) + sphere.radius + 1;
    const distance = Math.max(position.distanceTo(target), back);
    const eye = new Vector3(0, 0, distance).applyQuaternion(quaternion).add(target);
    return { position: eye, quaternion, fov, size: height, far: distance + back };
  }

  dispose(): void {
    this.flight.dispose();
  }

  /** Frames the selection, or everything when nothing is selected. */
  focus(camera: EditorCamera = this.editorCamera): void {
    const { selectedObjects, scene } = this.document;
    // matrices are updated, since an object may have been added after the last frame
    scene.three.updateMatrixWorld();
    const box = boundsOf(selectedObjects.length > 0 ? selectedObjects : scene.roots);
    if (!box.isEmpty()) camera.focus(box);
  }
}
