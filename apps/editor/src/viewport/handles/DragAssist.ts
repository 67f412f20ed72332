import { isComposing, latinKey, toRadians, type TransformMode } from '@farol/editing';
import type { GameObject, Scene } from '@farol/engine';
import { type Camera, type Object3D, Quaternion, Raycaster, Vector2, Vector3 } from 'three';
import { amountSigns, amountText } from './amountText';
import { DragReadout, type ReadoutLine } from './DragReadout';
import { DragSnap, type SnapTarget } from './DragSnap';
import { TypedAmounts } from './TypedAmounts';
import './handles.css';

/** State of a drag when a handle of the gizmo is grabbed. */
export interface AssistedDrag {
  readonly scene: Scene;
  readonly camera: Camera;
  readonly mode: TransformMode;
  /** Name of the handle: 'X', 'XY', 'XYZ', and for rotations also 'E' and 'XYZE'. */
  readonly axis: string;
  readonly space: 'world' | 'local';
  readonly dragged: readonly GameObject[];
  /** Object that three's handles move; not a descendant of any of the dragged GameObjects. */
  readonly pivot: Object3D;
}

/** Settings that may change during a drag. */
export interface DragChoices {
  /** Snapping target; null for none, or for the grid, to which three's handles snap. */
  readonly snapTo: Exclude<SnapTarget, 'grid'> | null;
  readonly alignsToSurface: boolean;
}

const AXES: Readonly<Record<string, Vector3>> = {
  X: new Vector3(1, 0, 0),
  Y: new Vector3(0, 1, 0),
  Z: new Vector3(0, 0, 1),
};

/** Name of the plane handle perpendicular to an axis, by the axis. */
const PLANES: Readonly<Record<string, string>> = { X: 'YZ', Y: 'XZ', Z: 'XY' };

const turn = new Quaternion();
const raycaster = new Raycaster();

/**
 * Extends a drag of three's handles: typed numbers, snapping to surfaces and vertices, and a readout beside the
 * pointer.
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
  /** Axes that numbers can be typed for; a single '' for a uniform scale or a free rotation. */
  private letters: readonly string[] = [];

  /**
   * @param onTyped - called when the typed number changes
   * @param onEnd - called when Enter (true) or Escape (false) ends the drag
   * @param onAxis - called with the name of a handle when its letter is pressed: X, or with Shift the plane without X
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
   * Restarts the drag with another handle from its first pointer position, and resets the pivot.
   * @returns that pointer position, in normalised device coordinates
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

  /** Pointer position in normalised device coordinates. */
  get place(): Vector2 {
    return this.pointer;
  }

  /** Sets up the axes of a drag, with no number typed yet. */
  private follow(drag: AssistedDrag): void {
    const { mode, axis } = drag;
    this.drag = drag;
    const isUniform = mode === 'rotate' || (mode === 'scale' && axis.startsWith('XYZ'));
    this.letters = isUniform
      ? [mode === 'rotate' && axis in AXES ? axis : '']
      : [...axis].filter((each) => each in AXES);
    this.typed = new TypedAmounts(Math.max(1, this.letters.length));
  }

  /** Called when the drag is over: hides the readout, and stops listening to keys. */
  end(): void {
    window.removeEventListener('keydown', this.keyDown, true);
    this.readout.hide();
    this.drag = null;
    this.typed = null;
    this.snap = null;
  }

  /**
   * Moves the pivot to the snapped or typed position, in place of the one by three's handles, and shows the amount.
   * @returns whether the drag is a move that also rotates the pivot
   */
  apply(choices: DragChoices): boolean {
    const { drag, typed } = this;
    if (!drag || !typed) return false;
    let turns = false;
    this.readout.markAt(null);
    // three's handles do not reset the rotation during a move
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

  /** Direction of an axis of the handles (world). */
  private axisOf(letter: string, { space, axis, camera, mode }: AssistedDrag): Vector3 {
    const known = AXES[letter];
    // the handle 'E' rotates about the view direction
    if (!known) return new Vector3().setFromMatrixColumn(camera.matrixWorld, 2).normalize();
    const isLocal = mode !== 'scale' && space === 'local' && axis !== 'XYZ';
    return known.clone().applyQuaternion(isLocal ? this.startTurn : turn.identity());
  }

  /** Removes the components of a movement that the handle does not allow. */
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
      // the scale is never set to 0, which dragging could not change any more
      else if (letter === '') pivot.scale.setScalar(value || 1);
      else pivot.scale.setComponent('XYZ'.indexOf(letter), value || 1);
    });
  }

  /** Amount of the drag along an axis: m, rad or a factor. */
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
    // the readout's position is relative to the canvas's parent, which may be larger than this view
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
