import { type Object3D, type PerspectiveCamera, Quaternion, Scene, type Vector2, Vector3 } from 'three';
import { TransformControls } from 'three/addons/controls/TransformControls.js';
import type { Session } from '../model/Session';

export type GizmoMode = 'translate' | 'rotate' | 'scale';

/** Place, turn and size of an object. */
class Pose {
  private readonly position = new Vector3();
  private readonly quaternion = new Quaternion();
  private readonly scale = new Vector3();

  constructor(private readonly object: Object3D) {
    this.position.copy(object.position);
    this.quaternion.copy(object.quaternion);
    this.scale.copy(object.scale);
  }

  apply(): void {
    const { object } = this;
    object.position.copy(this.position);
    object.quaternion.copy(this.quaternion);
    object.scale.copy(this.scale);
    if (!object.matrixAutoUpdate) object.updateMatrix();
  }

  equals({ position, quaternion, scale }: Pose): boolean {
    return this.position.equals(position) && this.quaternion.equals(quaternion) && this.scale.equals(scale);
  }
}

const labels: Record<GizmoMode, string> = { translate: 'move', rotate: 'turn', scale: 'scale' };

/** three's TransformControls on the selected object, in a scene of their own; one drag is one step of history. */
export class Gizmo {
  readonly scene = new Scene();
  private readonly controls: TransformControls;
  private before: Pose | null = null;
  private readonly end: () => void;

  constructor(private readonly session: Session) {
    this.controls = new TransformControls(session.camera);
    this.scene.add(this.controls.getHelper());
    this.controls.addEventListener('objectChange', () => {
      const { object } = this.controls;
      if (object && !object.matrixAutoUpdate) object.updateMatrix();
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
    return this.before !== null;
  }

  /** Brings the gizmo to where its object and the camera are. @returns whether there is something to draw */
  update(): boolean {
    const { session, controls } = this;
    controls.camera = session.camera as PerspectiveCamera;
    if (session.selected && !session.holds(session.selected)) session.selected = null; // the page took it away
    return controls.object !== undefined;
  }

  /** Lights up the handle at a point of the picture. @returns whether there is one */
  hover(at: Vector2): boolean {
    if (!this.update()) return false;
    this.controls.pointerHover(pointer(at, -1));
    return this.controls.axis !== null;
  }

  begin(at: Vector2): void {
    this.before = new Pose(this.controls.object!);
    this.controls.pointerDown(pointer(at, 0));
  }

  drag(at: Vector2): void {
    this.controls.pointerMove(pointer(at, -1));
  }

  /** Ends a drag, as a step of history, or by putting the object back. */
  finish(at: Vector2, keep: boolean): void {
    const { before, controls, session } = this;
    const object = controls.object;
    this.before = null;
    controls.pointerUp(pointer(at, 0));
    if (!before || !object) return;
    const after = new Pose(object);
    if (after.equals(before)) return;
    if (keep) {
      const label = `${labels[this.mode]} of ${object.name || object.type}`;
      session.history.keep({ label, undo: () => before.apply(), redo: () => after.apply() });
    } else {
      before.apply();
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
    const { selected } = session;
    if (selected && selected !== session.scene && selected.parent) controls.attach(selected);
    else controls.detach();
  }
}

/** A pointer as TransformControls take it: normalised device coordinates and a button. */
function pointer({ x, y }: Vector2, button: number): PointerEvent {
  return { x, y, button } as PointerEvent;
}
