import { Vector2 } from 'three';
import type { Viewport } from './Viewport';

/** A press that moves farther than this (CSS pixels) is a drag, not a click. */
const CLICK_REACH = 4;

/** Selects what is clicked: alone, or with Ctrl or Shift one more or one less. */
export class PointerPicker {
  private readonly from = new Vector2();
  private readonly point = new Vector2();
  private pointer: number | null = null;

  constructor(private readonly viewport: Viewport) {
    const { canvas } = viewport;
    canvas.addEventListener('pointerdown', this.pointerDown);
    canvas.addEventListener('pointerup', this.pointerUp);
  }

  dispose(): void {
    const { canvas } = this.viewport;
    canvas.removeEventListener('pointerdown', this.pointerDown);
    canvas.removeEventListener('pointerup', this.pointerUp);
  }

  private readonly pointerDown = (event: PointerEvent): void => {
    this.viewport.canvas.focus({ preventScroll: true });
    if (event.button !== 0 || this.viewport.gizmo.isHot) {
      this.pointer = null;
      return;
    }
    // a second finger makes it no click
    this.pointer = event.isPrimary ? event.pointerId : null;
    this.from.set(event.clientX, event.clientY);
  };

  private readonly pointerUp = (event: PointerEvent): void => {
    if (event.pointerId !== this.pointer) return;
    this.pointer = null;
    if (this.from.distanceTo(this.point.set(event.clientX, event.clientY)) > CLICK_REACH) return;
    const { viewport } = this;
    const { left, top, width, height } = viewport.canvas.getBoundingClientRect();
    this.point.set(((event.clientX - left) / width) * 2 - 1, 1 - ((event.clientY - top) / height) * 2);
    const object = viewport.pick(this.point);
    const { selection } = viewport.document;
    if (event.ctrlKey || event.metaKey || event.shiftKey) {
      if (object) selection.toggle(object.id);
    } else selection.set(object ? [object.id] : []);
  };
}
