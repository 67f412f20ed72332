import { type Command, type Gesture, SetFields, t } from '@farol/editing';
import type { Camera as CameraComponent } from '@farol/engine';
import { Matrix4, OrthographicCamera, Quaternion, Vector3 } from 'three';
import { poseEdits, poseProblem } from '../model/cameraEdits';
import type { EditorDocument } from '../model/EditorDocument';
import type { EditorCamera } from './EditorCamera';

/** Notches of the wheel, and presses of keys, that are no farther apart than this (ms) are one step. */
const BURST = 1000;

/** No camera's place. */
const NOWHERE = Array.from({ length: 16 }, () => 0) as Parameters<Matrix4['set']>;

const turn = new Quaternion();

/**
 * Moves a camera of the scene as the editor's own moves, while it is looked through: each drag, flight or burst of the
 * wheel is one step of history.
 */
export class CameraFlight {
  private flown: CameraComponent | null = null;
  private gesture: Gesture | null = null;
  private isHeld = false;
  /** The roll of the camera, which the controls do not have. */
  private readonly roll = new Quaternion();
  private readonly pose = { position: new Vector3(), quaternion: new Quaternion() };
  /** Where the camera was last, with its lens. */
  private readonly world = new Matrix4();
  private readonly lens = new Matrix4();
  /** What `problem` was found of, and it. */
  private problemOf = '';
  private lastProblem: string | null = null;
  private step: Command | null = null;
  private steppedAt = -Infinity;

  /** @param match - brings the editor's camera to where a camera of the scene is */
  constructor(
    private readonly document: EditorDocument,
    private readonly own: EditorCamera,
    private readonly canvas: HTMLCanvasElement,
    private readonly match: (camera: CameraComponent) => void,
  ) {
    canvas.addEventListener('pointerdown', this.pointerDown, true);
    window.addEventListener('pointerup', this.pointerUp, true);
    window.addEventListener('pointercancel', this.pointerUp, true);
    window.addEventListener('blur', this.pointerUp);
  }

  /** The camera that is flown; null for none. */
  get camera(): CameraComponent | null {
    return this.flown;
  }

  set camera(camera: CameraComponent | null) {
    this.end();
    this.flown = camera;
    this.own.glides = camera === null;
    this.world.set(...NOWHERE);
    this.problemOf = '';
  }

  /** Why the camera cannot be moved, in a sentence with the mend; null where it can, and where there is none. */
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

  /** Before the editor's camera moves: takes over what else has moved the scene's. */
  follow(): void {
    const { flown, own } = this;
    if (!flown?.isAttached || this.problem !== null) return;
    const { three } = flown;
    three.updateWorldMatrix(true, false);
    if (three.matrixWorld.equals(this.world) && three.projectionMatrix.equals(this.lens)) return;
    this.match(flown);
    three.getWorldQuaternion(this.roll).premultiply(turn.copy(own.perspective.quaternion).invert());
    this.note(flown);
  }

  /** After the editor's camera has moved, or not. */
  update(hasMoved: boolean): void {
    const { flown, document } = this;
    if (!flown?.isAttached) return;
    if (hasMoved && this.problem === null) {
      const command = this.command(flown);
      if (this.isHeld || this.gesture?.isOpen) {
        // another edit has ended the gesture: what follows is a step of its own
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
    const { own, pose } = this;
    pose.position.copy(own.perspective.position);
    pose.quaternion.copy(own.perspective.quaternion).multiply(this.roll);
    const edits = poseEdits(camera.gameObject, pose);
    if (camera.three instanceof OrthographicCamera) edits.push({ owner: camera, name: 'size', value: own.height });
    return new SetFields(t('Fly {name}', { name: camera.gameObject.name }), edits);
  }

  /** What has no end of its own: joins the step before where that is as young. */
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
