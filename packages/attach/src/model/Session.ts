import { CommandStack, Selection, Signal } from '@farol/editing';
import { type Camera, type Object3D, Vector4, type WebGLRenderer } from 'three';

/**
 * State that the parts of an attached editor share: the page's scene, camera and renderer, the selection and the
 * history.
 */
export class Session {
  /** Selected objects, in order of selection. */
  readonly selection = new Selection<Object3D>();
  readonly commands = new CommandStack<Object3D>(({ selection }, isDone) => {
    if (selection) this.selection.set(isDone ? selection.done : selection.undone);
  });
  /**
   * Viewport of the page's last draw of the scene with the camera: left, bottom, width and height, as shares of the
   * canvas's size.
   */
  readonly view = new Vector4(0, 0, 1, 1);
  /** Emits when the scene was edited, also by undo and redo, and while an edit is under way. */
  readonly edited = new Signal();
  /** Emits when `problem` changes. */
  readonly problemChanged = new Signal();
  private message = '';

  constructor(
    readonly scene: Object3D,
    /** Camera that the page draws with, also used by gizmo and picking. */
    public camera: Camera,
    readonly webgl: WebGLRenderer,
  ) {
    this.commands.changed.subscribe(this.edited.emit);
  }

  /** Selects an object alone, or nothing. */
  select(object: Object3D | null): void {
    this.selection.set(object ? [object] : []);
  }

  /** Selected objects in the scene that are not the scene itself and have no selected ancestor. */
  get topmost(): Object3D[] {
    const { items } = this.selection;
    const chosen = new Set(items);
    return items.filter((object) => {
      if (object === this.scene || !object.parent) return false;
      for (let above: Object3D | null = object.parent; above; above = above.parent) if (chosen.has(above)) return false;
      return true;
    });
  }

  /** Whether an object is the scene or one of its descendants. */
  holds(object: Object3D): boolean {
    for (let each: Object3D | null = object; each; each = each.parent) if (each === this.scene) return true;
    return false;
  }

  /** Deselects objects that the page has removed from the scene. */
  dropLost(): void {
    const { selection } = this;
    if (!selection.items.every((object) => this.holds(object)))
      selection.set(selection.items.filter((object) => this.holds(object)));
  }

  /** Message of the error that the last `attempt` threw; '' when the attempt succeeded. */
  get problem(): string {
    return this.message;
  }

  /** Runs a function; the message of an error that it throws becomes `problem`. */
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
