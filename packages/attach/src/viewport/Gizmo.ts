import { type PerspectiveCamera, Scene, type Vector2 } from 'three';
import { TransformControls } from 'three/addons/controls/TransformControls.js';
import type { Session } from '../model/Session';
import { Drag } from './Drag';

export type GizmoMode = 'translate' | 'rotate' | 'scale';

const labels: Record<GizmoMode, string> = { translate: 'move', rotate: 'turn', scale: 'scale' };

/**
 * three's TransformControls on the object that was selected last, in a scene of their own; the others that are selected
 * follow it. One drag is one step of history.
 */
export class Gizmo {
  readonly scene = new Scene();
  private readonly controls: TransformControls;
  private current: Drag | null = null;
  private readonly end: () => void;

  constructor(private readonly session: Session) {
    this.controls = new TransformControls(session.camera);
    this.scene.add(this.controls.getHelper());
    this.controls.addEventListener('objectChange', () => {
      this.current?.follow(this.mode === 'scale');
      session.edited.emit();
    });
    this.end = session.selectionChanged.listen(() => this.follow());
  }

  get mode(): GizmoMode {
    return this.controls.mode as GizmoMode;
  }

  set mode(mode: GizmoMode) {
    this.controls.setMode(mode);
    this.session.edited.emit();
  }

  get space(): 'local' | 'world' {
    return this.controls.space;
  }

  set space(space: 'local' | 'world') {
    this.controls.setSpace(space);
    this.session.edited.emit();
  }

  get isDragging(): boolean {
    return this.current !== null;
  }

  /** Brings the gizmo to where its object and the camera are. @returns whether there is something to draw */
  update(): boolean {
    const { session, controls } = this;
    controls.camera = session.camera as PerspectiveCamera;
    session.dropLost();
    return controls.object !== undefined;
  }

  /** Lights up the handle at a point of the picture. @returns whether there is one */
  hover(at: Vector2): boolean {
    if (!this.update()) return false;
    // the handles are where the object is now, not where they were drawn last
    this.controls.getHelper().updateMatrixWorld(true);
    this.controls.pointerHover(pointer(at, -1));
    return this.controls.axis !== null;
  }

  begin(at: Vector2): void {
    const { topmost } = this.session;
    const leader = this.controls.object!;
    this.current = new Drag(
      leader,
      topmost.filter((object) => object !== leader),
    );
    this.controls.pointerDown(pointer(at, 0));
  }

  drag(at: Vector2): void {
    this.controls.pointerMove(pointer(at, -1));
  }

  /** Ends a drag, as a step of history, or by putting the object back. */
  finish(at: Vector2, keep: boolean): void {
    const { current, controls, session } = this;
    const { object } = controls;
    this.current = null;
    controls.pointerUp(pointer(at, 0));
    if (!current || !object) return;
    const redo = current.finish();
    if (!redo) return;
    if (keep) {
      const count = session.topmost.length;
      const name = count > 1 ? `${count} objects` : object.name || object.type;
      session.history.keep({ label: `${labels[this.mode]} of ${name}`, undo: () => current.undo(), redo });
    } else {
      current.undo();
      session.edited.emit();
    }
  }

  dispose(): void {
    this.end();
    this.controls.detach();
    this.controls.getHelper().dispose();
  }

  private follow(): void {
    const { controls, session } = this;
    // of what is selected together with something above it, that one moves
    const object = session.topmost.at(-1);
    if (object) controls.attach(object);
    else controls.detach();
  }
}

/** A pointer as TransformControls take it: normalised device coordinates and a button. */
function pointer({ x, y }: Vector2, button: number): PointerEvent {
  return { x, y, button } as PointerEvent;
}
