import { type Command, type Gesture, SetFields, t } from '@farol/editing';
import type { Camera as CameraComponent } from '@farol/engine';
import { Matrix4, OrthographicCamera, Quaternion, Vector3 } from 'three';
import { poseEdits, poseProblem } from '../model/cameraEdits';
import type { EditorDocument } from '../model/EditorDocument';
import type { EditorCamera } from './EditorCamera';

/** Largest interval (ms) between wheel notches or key presses that are one step of history. */
const BURST = 1000;

/** Elements of a matrix that no camera has: a camera's matrix compared with it always counts as changed. */
const NOWHERE = Array.from({ length: 16 }, () => 0) as Parameters<Matrix4['set']>;

const turn = new Quaternion();

/**
 * Moves a camera of the scene with the editor camera's controls while its view is shown. Each drag, flight or burst of
 * the wheel is one step of history.
 */
export class CameraFlight {
  private flown: CameraComponent | null = null;
  private gesture: Gesture | null = null;
  private isHeld = false;
  /** Roll of the scene's camera relative to the editor's camera, whose controls have no roll. */
  private readonly roll = new Quaternion();
  private readonly pose = { position: new Vector3(), quaternion: new Quaternion() };
  /** World matrix of the scene's camera when it was last read or moved; `lens` is its projection matrix. */
  private readonly world = new Matrix4();
  private readonly lens = new Matrix4();
  /** Key of the state for which `lastProblem` was computed. */
  private problemOf = '';
  private lastProblem: string | null = null;
  private step: Command | null = null;
  private steppedAt = -Infinity;

  /** @param match - moves the editor's camera to a camera of the scene */
  constructor(
    private readonly document: EditorDocument,
    private readonly editorCamera: EditorCamera,
    private readonly canvas: HTMLCanvasElement,
    private readonly match: (camera: CameraComponent) => void,
  ) {
    canvas.addEventListener('pointerdown', this.pointerDown, true);
    window.addEventListener('pointerup', this.pointerUp, true);
    window.addEventListener('pointercancel', this.pointerUp, true);
    window.addEventListener('blur', this.pointerUp);
  }

  /** The scene's camera that is moved; null when none is. */
  get camera(): CameraComponent | null {
    return this.flown;
  }

  set camera(camera: CameraComponent | null) {
    this.end();
    this.flown = camera;
    this.editorCamera.glides = camera === null;
    this.world.set(...NOWHERE);
    this.problemOf = '';
  }

  /** Why the camera cannot be moved, in a sentence with the remedy; null when it can, or when no camera is moved. */
  get problem(): string | null {
    const { flown, document } = this;
    if (!flown?.isAttached) return null;
    if (document.simulation.state !== 'stopped') return t('The scene plays: stop it to move this camera.');
    const key = `${document.edited.revision} ${flown.id}`;
    if (key !== this.problemOf) {
      this.problemOf = key;
      this.lastProblem = poseProblem(flown);
    }
    return this.lastProblem;
  }

  /** Called before the editor's camera moves: takes over the scene camera's pose if something else has changed it. */
  follow(): void {
    const { flown, editorCamera } = this;
    if (!flown?.isAttached || this.problem !== null) return;
    const { three } = flown;
    three.updateWorldMatrix(true, false);
    if (three.matrixWorld.equals(this.world) && three.projectionMatrix.equals(this.lens)) return;
    this.match(flown);
    three.getWorldQuaternion(this.roll).premultiply(turn.copy(editorCamera.perspective.quaternion).invert());
    this.note(flown);
  }

  /** Moves the scene's camera with the editor's, as an edit. @param hasMoved - whether the editor's camera moved */
  update(hasMoved: boolean): void {
    const { flown, document } = this;
    if (!flown?.isAttached) return;
    if (hasMoved && this.problem === null) {
      const command = this.command(flown);
      if (this.isHeld || this.gesture?.isOpen) {
        // another edit has ended the gesture: further movement becomes another step of history
        if (!this.gesture?.isOpen) this.gesture = document.commands.begin();
        this.gesture.preview(command);
      } else this.runStep(command);
      this.note(flown);
    }
    if (!this.isHeld) this.end();
  }

  dispose(): void {
    this.end();
    this.canvas.removeEventListener('pointerdown', this.pointerDown, true);
    window.removeEventListener('pointerup', this.pointerUp, true);
    window.removeEventListener('pointercancel', this.pointerUp, true);
    window.removeEventListener('blur', this.pointerUp);
  }

  private note({ three }: CameraComponent): void {
    three.updateWorldMatrix(true, false);
    this.world.copy(three.matrixWorld);
    this.lens.copy(three.projectionMatrix);
  }

  private command(camera: CameraComponent): Command {
    const { editorCamera, pose } = this;
    pose.position.copy(editorCamera.perspective.position);
    pose.quaternion.copy(editorCamera.perspective.quaternion).multiply(this.roll);
    const edits = poseEdits(camera.gameObject, pose);
    if (camera.three instanceof OrthographicCamera)
      edits.push({ owner: camera, name: 'size', value: editorCamera.height });
    return new SetFields(t('Fly {name}', { name: camera.gameObject.name }), edits);
  }

  /** Runs a command as a step of history, for movement without a clear end (wheel, keys); a recent step is amended. */
  private runStep(command: Command): void {
    const { commands } = this.document;
    const now = performance.now();
    const isBurst = this.step !== null && now - this.steppedAt < BURST && commands.amend(this.step, command);
    if (!isBurst) commands.run(command);
    this.step = commands.last;
    this.steppedAt = now;
  }

  private end(): void {
    this.gesture?.commit();
    this.gesture = null;
  }

  private readonly pointerDown = (): void => {
    this.isHeld = this.flown !== null;
    this.step = null;
  };

  private readonly pointerUp = (): void => void (this.isHeld = false);
}
