import type { Camera, Object3D, WebGLRenderer } from 'three';
import { History } from './History';
import { Signal } from './Signal';

/** What the parts of an attached editor share: the page's scene, camera and renderer, the selection and the history. */
export class Session {
  readonly history = new History();
  /** Emits when another object, or none, is selected. */
  readonly selectionChanged = new Signal();
  /** Emits when the scene was edited, also by undo and redo, and while an edit is under way. */
  readonly edited = new Signal();
  private object: Object3D | null = null;

  constructor(
    readonly scene: Object3D,
    /** What the page looks through; the gizmo and picking follow it. */
    public camera: Camera,
    readonly webgl: WebGLRenderer,
  ) {
    this.history.changed.listen(() => this.edited.emit());
  }

  /** The selected object, or null. */
  get selected(): Object3D | null {
    return this.object;
  }

  set selected(object: Object3D | null) {
    if (object === this.object) return;
    this.object = object;
    this.selectionChanged.emit();
  }

  /** Whether an object is the scene or somewhere below it. */
  holds(object: Object3D): boolean {
    for (let each: Object3D | null = object; each; each = each.parent) if (each === this.scene) return true;
    return false;
  }
}
