import type { Camera, Object3D, WebGLRenderer } from 'three';
import { History } from './History';
import { Signal } from './Signal';

/** What the parts of an attached editor share: the page's scene, camera and renderer, the selection and the history. */
export class Session {
  readonly history = new History();
  /** Emits when something else, or nothing, is selected. */
  readonly selectionChanged = new Signal();
  /** Emits when the scene was edited, also by undo and redo, and while an edit is under way. */
  readonly edited = new Signal();
  /** Emits when `problem` changes. */
  readonly problemChanged = new Signal();
  private objects: readonly Object3D[] = [];
  private message = '';

  constructor(
    readonly scene: Object3D,
    /** What the page looks through; the gizmo and picking follow it. */
    public camera: Camera,
    readonly webgl: WebGLRenderer,
  ) {
    this.history.changed.listen(() => this.edited.emit());
  }

  /** The selected objects, in the order of their choice. */
  get selection(): readonly Object3D[] {
    return this.objects;
  }

  set selection(objects: readonly Object3D[]) {
    const next = [...new Set(objects)];
    if (next.length === this.objects.length && next.every((object, i) => object === this.objects[i])) return;
    this.objects = next;
    this.selectionChanged.emit();
  }

  /** The object that was selected last, or null; setting it selects it alone. */
  get selected(): Object3D | null {
    return this.objects.at(-1) ?? null;
  }

  set selected(object: Object3D | null) {
    this.selection = object ? [object] : [];
  }

  /** Selects an object besides the others, or no longer. */
  toggle(object: Object3D): void {
    const others = this.objects.filter((each) => each !== object);
    this.selection = others.length < this.objects.length ? others : [...others, object];
  }

  /** The selected objects that have a place in the scene and are not below another one of them. */
  get topmost(): Object3D[] {
    const chosen = new Set(this.objects);
    return this.objects.filter((object) => {
      if (object === this.scene || !object.parent) return false;
      for (let above: Object3D | null = object.parent; above; above = above.parent) if (chosen.has(above)) return false;
      return true;
    });
  }

  /** Whether an object is the scene or somewhere below it. */
  holds(object: Object3D): boolean {
    for (let each: Object3D | null = object; each; each = each.parent) if (each === this.scene) return true;
    return false;
  }

  /** Deselects what the page has taken away. */
  dropLost(): void {
    if (!this.objects.every((object) => this.holds(object)))
      this.selection = this.objects.filter((object) => this.holds(object));
  }

  /** Why the last thing that was asked for was not done; '' when it was. */
  get problem(): string {
    return this.message;
  }

  /** Does something; what it throws becomes `problem`. */
  attempt(run: () => void): void {
    let message = '';
    try {
      run();
    } catch (error) {
      message = error instanceof Error ? error.message : String(error);
    }
    if (message === this.message) return;
    this.message = message;
    this.problemChanged.emit();
  }
}
