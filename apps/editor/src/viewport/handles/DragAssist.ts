import { isComposing, latinKey, toRadians, type TransformMode } from '@farol/editing';
import type { GameObject, Scene } from '@farol/engine';
import { type Camera, type Object3D, Quaternion, Raycaster, Vector2, Vector3 } from 'three';
import { amountSigns, amountText } from './amountText';
import { DragReadout, type ReadoutLine } from './DragReadout';
import { DragSnap, type SnapTarget } from './DragSnap';
import { TypedAmounts } from './TypedAmounts';
import './handles.css';

/** A drag of the handles, as it begins. */
export interface AssistedDrag {
  readonly scene: Scene;
  readonly camera: Camera;
  readonly mode: TransformMode;
  /** What the handle is called: 'X', 'XY', 'XYZ', or of a rotation 'E' and 'XYZE' too. */
  readonly axis: string;
  readonly space: 'world' | 'local';
  readonly dragged: readonly GameObject[];
  /** Follows the pointer; below nothing that is moved. */
  readonly pivot: Object3D;
}

/** What is asked of the handles while a drag goes on. */
export interface DragChoices {
  /** What it holds to; null for nothing, or for the grid, which three's handles do. */
  readonly snapTo: Exclude<SnapTarget, 'grid'> | null;
  readonly alignsToSurface: boolean;
}

const AXES: Readonly<Record<string, Vector3>> = {
  X: new Vector3(1, 0, 0),
  Y: new Vector3(0, 1, 0),
  Z: new Vector3(0, 0, 1),
};

/** The handles that lead along all but one axis. */
const PLANES: Readonly<Record<string, string>> = { X: 'YZ', Y: 'XZ', Z: 'XY' };

const turn = new Quaternion();
const raycaster = new Raycaster();

/**
 * Helps a drag of the handles: numbers are typed for it, it holds to surfaces and vertices, and what it has come to is
 * said beside the pointer.
 */
export class DragAssist {
  private readonly readout: DragReadout;
  private readonly pointer = new Vector2();
  private readonly pointerStart = new Vector2();
  private drag: AssistedDrag | null = null;
  private typed: TypedAmounts | null = null;
  private snap: DragSnap | null = null;
  private readonly start = new Vector3();
  private readonly startTurn = new Quaternion();
  /** Letters of the axes that numbers are for; one for what is the same along all. */
  private letters: readonly string[] = [];

  /**
   * @param onTyped - called when another number is typed
   * @param onEnd - called when Enter (true) or Escape (false) ends the drag
   * @param onAxis - called with the name of a handle when its letter is pressed: X, or with Shift all but X
   */
  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly onTyped: () => void,
    private readonly onEnd: (keeps: boolean) => void,
    private readonly onAxis: (axis: string) => void,
  ) {
    this.readout = new DragReadout(canvas);
    canvas.addEventListener('pointerdown', this.pointerMoved, true);
    canvas.addEventListener('pointermove', this.pointerMoved, true);
  }

  dispose(): void {
    this.end();
    this.canvas.removeEventListener('pointerdown', this.pointerMoved, true);
    this.canvas.removeEventListener('pointermove', this.pointerMoved, true);
  }

  begin(drag: AssistedDrag): void {
    this.end();
    const { mode, pivot, scene, dragged } = drag;
    this.start.copy(pivot.position);
    this.startTurn.copy(pivot.quaternion);
    this.pointerStart.copy(this.pointer);
    this.follow(drag);
    this.snap = mode === 'translate' ? new DragSnap(scene, dragged, pivot) : null;
    window.addEventListener('keydown', this.keyDown, true);
  }

  /**
   * Has the drag begin anew with another handle, where the pointer was then, and puts the pivot back.
   * @returns that place, in normalised device coordinates
   */
  regrab(axis: string): Vector2 {
    const { drag, start, startTurn, pointerStart } = this;
    if (!drag) return pointerStart;
    drag.pivot.position.copy(start);
    drag.pivot.quaternion.copy(startTurn);
    drag.pivot.scale.set(1, 1, 1);
    this.follow({ ...drag, axis });
    return pointerStart;
  }

  /** Where the pointer is, in normalised device coordinates. */
  get place(): Vector2 {
    return this.pointer;
  }

  /** Takes a drag's axes, with no number typed for them yet. */
  private follow(drag: AssistedDrag): void {
    const { mode, axis } = drag;
    this.drag = drag;
    const isUniform = mode === 'rotate' || (mode === 'scale' && axis.startsWith('XYZ'));
    this.letters = isUniform
      ? [mode === 'rotate' && axis in AXES ? axis : '']
      : [...axis].filter((each) => each in AXES);
    this.typed = new TypedAmounts(Math.max(1, this.letters.length));
  }

  /** The drag is over. */
  end(): void {
    window.removeEventListener('keydown', this.keyDown, true);
    this.readout.hide();
    this.drag = null;
    this.typed = null;
    this.snap = null;
  }

  /**
   * Puts the pivot, which three's handles have moved, to where the drag leads, and says how far that is.
   * @returns whether the pivot is turned although the drag moves
   */
  apply(choices: DragChoices): boolean {
    const { drag, typed } = this;
    if (!drag || !typed) return false;
    let turns = false;
    this.readout.markAt(null);
    // of a move three's handles leave the turn as it was
    if (drag.mode === 'translate') drag.pivot.quaternion.copy(this.startTurn);
    if (typed.isTyped) this.applyTyped(drag, typed);
    else if (choices.snapTo) turns = this.applySnap(drag, choices);
    this.say(drag, typed);
    return turns;
  }

  private applySnap({ pivot, camera, axis }: AssistedDrag, { snapTo, alignsToSurface }: DragChoices): boolean {
    const { snap } = this;
    if (!snap) return false;
    raycaster.setFromCamera(this.pointer, camera);
    const { ray } = raycaster;
    const restrict = (way: Vector3): void => this.restrict(way);
    if (snapTo === 'surface') {
      const turns = alignsToSurface && axis === 'XYZ';
      return snap.toSurface(pivot, ray, camera, turns, restrict) && turns;
    }
    const vertex = snap.toVertex(pivot, ray, camera, restrict);
    if (!vertex) return false;
    const { x, y } = vertex.project(camera);
    const { clientWidth, clientHeight } = this.canvas;
    this.readout.markAt({ x: ((x + 1) / 2) * clientWidth, y: ((1 - y) / 2) * clientHeight });
    return false;
  }

  /** An axis of the handles, in the world. */
  private axisOf(letter: string, { space, axis, camera, mode }: AssistedDrag): Vector3 {
    const known = AXES[letter];
    // turned with the view: about where one looks along
    if (!known) return new Vector3().setFromMatrixColumn(camera.matrixWorld, 2).normalize();
    const isLocal = mode !== 'scale' && space === 'local' && axis !== 'XYZ';
    return known.clone().applyQuaternion(isLocal ? this.startTurn : turn.identity());
  }

  /** Leaves of a way what the handle allows. */
  private restrict(way: Vector3): void {
    const { drag, letters } = this;
    if (!drag || letters.length === 3) return;
    const allowed = new Vector3();
    for (const letter of letters) {
      const axis = this.axisOf(letter, drag);
      allowed.addScaledVector(axis, axis.dot(way));
    }
    way.copy(allowed);
  }

  private applyTyped(drag: AssistedDrag, typed: TypedAmounts): void {
    const { pivot, mode } = drag;
    pivot.position.copy(this.start);
    pivot.quaternion.copy(this.startTurn);
    pivot.scale.set(1, 1, 1);
    this.letters.forEach((letter, i) => {
      const value = typed.valueOf(i);
      if (value === null) return;
      if (mode === 'translate') pivot.position.addScaledVector(this.axisOf(letter, drag), value);
      else if (mode === 'rotate')
        pivot.quaternion.premultiply(turn.setFromAxisAngle(this.axisOf(letter, drag), toRadians(value)));
      // a size of 0 could not be brought back
      else if (letter === '') pivot.scale.setScalar(value || 1);
      else pivot.scale.setComponent('XYZ'.indexOf(letter), value || 1);
    });
  }

  /** What the drag has come to along an axis: m, rad or a factor. */
  private amountOf(letter: string, drag: AssistedDrag): number {
    const { pivot, mode } = drag;
    if (mode === 'scale') return pivot.scale.getComponent(Math.max(0, 'XYZ'.indexOf(letter)));
    const axis = this.axisOf(letter, drag);
    if (mode === 'translate') return axis.dot(pivot.position.clone().sub(this.start));
    turn.copy(this.startTurn).invert().premultiply(pivot.quaternion);
    const along = axis.x * turn.x + axis.y * turn.y + axis.z * turn.z;
    if (letter === '') return 2 * Math.acos(Math.min(1, Math.abs(turn.w)));
    return 2 * Math.atan2(Math.sign(turn.w || 1) * along, Math.abs(turn.w));
  }

  private say(drag: AssistedDrag, typed: TypedAmounts): void {
    const [before, after] = amountSigns(drag.mode);
    const lines = this.letters.map((letter, i): ReadoutLine => {
      const text = typed.textOf(i);
      const axis = letter.toLowerCase();
      if (!typed.isTyped) return { axis, text: amountText(drag.mode, this.amountOf(letter, drag)) };
      const isTyped = i === typed.at;
      return { axis, text: `${before}${text}${isTyped ? '▏' : ''}${after}`, isTyped, isWrong: typed.isWrong(i) };
    });
    // the picture may be a part of what the readout is in
    const { left, top, width, height } = this.canvas.getBoundingClientRect();
    const whole = this.canvas.parentElement?.getBoundingClientRect() ?? { left, top };
    const x = left - whole.left + ((this.pointer.x + 1) / 2) * width;
    this.readout.show(lines, x, top - whole.top + ((1 - this.pointer.y) / 2) * height);
  }

  private readonly pointerMoved = ({ clientX, clientY }: PointerEvent): void => {
    const { left, top, width, height } = this.canvas.getBoundingClientRect();
    this.pointer.set(((clientX - left) / width) * 2 - 1, 1 - ((clientY - top) / height) * 2);
  };

  private readonly keyDown = (event: KeyboardEvent): void => {
    const { typed } = this;
    if (!typed || event.ctrlKey || event.metaKey || event.altKey || isComposing(event)) return;
    const isEnd = event.key === 'Enter' || event.key === 'Escape';
    const letter = latinKey(event).toUpperCase();
    const isAxis = letter in AXES;
    if (!isEnd && !isAxis && !typed.press(event)) return;
    event.preventDefault();
    event.stopPropagation();
    if (isEnd) this.onEnd(event.key === 'Enter');
    else if (isAxis) this.onAxis(event.shiftKey && this.drag?.mode !== 'rotate' ? PLANES[letter] : letter);
    else this.onTyped();
  };
}
