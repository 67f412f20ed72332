import type { GameObject } from '@farol/engine';
import { Vector2 } from 'three';
import type { PickSurface } from './PickSurface';

/** Movement (CSS pixels) that makes a press a drag, not a click. */
const CLICK_REACH = 4;

/** Selects the clicked object; Ctrl or Shift adds it to the selection, or removes it. */
export class PointerPicker {
  private readonly from = new Vector2();
  private readonly point = new Vector2();
  private pointer: number | null = null;

  constructor(private readonly viewport: PickSurface) {
    const { canvas } = viewport;
    canvas.addEventListener('pointerdown', this.pointerDown);
    canvas.addEventListener('pointerup', this.pointerUp);
  }

  dispose(): void {
    const { canvas } = this.viewport;
    canvas.removeEventListener('pointerdown', this.pointerDown);
    canvas.removeEventListener('pointerup', this.pointerUp);
  }

  /** The visible object at a point of the page (CSS pixels). */
  objectAt(x: number, y: number): GameObject | null {
    const { viewport } = this;
    const { left, top, width, height } = viewport.bounds;
    return viewport.pick(this.point.set(((x - left) / width) * 2 - 1, 1 - ((y - top) / height) * 2));
  }

  /** Prevents the current press from selecting. */
  cancel(): void {
    this.pointer = null;
  }

  private readonly pointerDown = (event: PointerEvent): void => {
    this.viewport.canvas.focus({ preventScroll: true });
    if (event.button !== 0 || this.viewport.gizmo.isHot) {
      this.pointer = null;
      return;
    }
    // a second finger cancels the click
    this.pointer = event.isPrimary ? event.pointerId : null;
    this.from.set(event.clientX, event.clientY);
  };

  private readonly pointerUp = (event: PointerEvent): void => {
    if (event.pointerId !== this.pointer) return;
    this.pointer = null;
    if (this.from.distanceTo(this.point.set(event.clientX, event.clientY)) > CLICK_REACH) return;
    const object = this.objectAt(event.clientX, event.clientY);
    const { selection } = this.viewport.document;
    if (event.ctrlKey || event.metaKey || event.shiftKey) {
      if (object) selection.toggle(object.id);
    } else selection.set(object ? [object.id] : []);
  };
}
