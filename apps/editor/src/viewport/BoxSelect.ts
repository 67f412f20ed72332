import { Vector2 } from 'three';
import type { pickBox } from './pickBox';
import type { PickSurface } from './PickSurface';

/** Distance (CSS pixels) beyond which a drag draws a selection box. */
const REACH = 4;

/**
 * Selects the objects in a box drawn over the viewport: by dragging while the select mode is on, or with Ctrl held,
 * which adds to the selection. Dragging with Alt orbits, and two fingers pan and zoom, as usual.
 */
export class BoxSelect {
  private readonly element = document.createElement('div');
  private readonly from = new Vector2();
  private readonly to = new Vector2();
  private readonly listening = new AbortController();
  private pointer: number | null = null;
  private isOpen = false;
  /** Function that returns the objects in a box; null until its code was fetched. */
  private find: typeof pickBox | null = null;

  constructor(private readonly viewport: PickSurface) {
    this.element.className = 'select-box';
    this.element.hidden = true;
    const { canvas } = viewport;
    // these listeners are registered before those of the camera, so that they run first
    const { signal } = this.listening;
    canvas.addEventListener('pointerdown', this.pointerDown, { capture: true, signal });
    canvas.addEventListener('pointermove', this.pointerMove, { signal });
    canvas.addEventListener('pointerup', this.pointerUp, { signal });
    canvas.addEventListener('pointercancel', this.cancel, { signal });
    window.addEventListener('keydown', this.keyDown, { capture: true, signal });
  }

  dispose(): void {
    this.cancel();
    this.listening.abort();
    this.element.remove();
  }

  private readonly pointerDown = (event: PointerEvent): void => {
    // a second finger moves the camera, and cancels the box
    if (this.pointer !== null && event.pointerId !== this.pointer) return this.cancel();
    const { viewport } = this;
    if (event.button !== 0 || event.altKey || event.shiftKey || viewport.gizmo.isHot) return;
    if (viewport.mode !== 'select' && !(event.ctrlKey || event.metaKey)) return;
    if (!viewport.editorCamera.enabled) return;
    this.pointer = event.pointerId;
    // a failure to fetch this code is reported when the box is drawn
    this.loadFind().catch(() => {});
    this.from.set(event.clientX, event.clientY);
    // with touch the controls stay enabled, so that a second finger can begin to pan and zoom
    if (event.pointerType === 'touch') viewport.editorCamera.oneFinger = false;
    else viewport.editorCamera.enabled = false;
  };

  private readonly pointerMove = (event: PointerEvent): void => {
    if (event.pointerId !== this.pointer) return;
    const { viewport, element, from, to } = this;
    to.set(event.clientX, event.clientY);
    if (!this.isOpen) {
      if (from.distanceTo(to) <= REACH) return;
      this.isOpen = true;
      viewport.canvas.setPointerCapture(event.pointerId);
      viewport.canvas.parentElement?.append(element);
      element.hidden = false;
    }
    const { left, top } = viewport.canvas.getBoundingClientRect();
    element.style.transform = `translate(${Math.min(from.x, to.x) - left}px, ${Math.min(from.y, to.y) - top}px)`;
    element.style.width = `${Math.abs(to.x - from.x)}px`;
    element.style.height = `${Math.abs(to.y - from.y)}px`;
  };

  private readonly pointerUp = (event: PointerEvent): void => {
    if (event.pointerId !== this.pointer) return;
    const { viewport, isOpen } = this;
    this.cancel();
    if (!isOpen) return;
    const adds = event.ctrlKey || event.metaKey;
    if (this.find) this.select(this.find, adds);
    else this.loadFind().then((find) => this.select(find, adds), viewport.onError);
  };

  /** Fetches the code that finds the objects in a box; called at the press, to be there when the box is drawn. */
  private async loadFind(): Promise<typeof pickBox> {
    return (this.find ??= (await import('./pickBox')).pickBox);
  }

  /** Selects the objects in the box. @param adds - whether to add them to the selection */
  private select(find: typeof pickBox, adds: boolean): void {
    const { document, camera, bounds } = this.viewport;
    const { scene, selection } = document;
    const { left, top, width, height } = bounds;
    const corners = [this.from, this.to].map(
      ({ x, y }) => new Vector2(((x - left) / width) * 2 - 1, 1 - ((y - top) / height) * 2),
    );
    const found = find(scene, camera, corners).map(({ id }) => id);
    selection.set(adds ? [...selection.ids, ...found] : found);
  }

  /** Removes the box; the current press draws no other box. */
  readonly cancel = (): void => {
    if (this.pointer === null) return;
    this.pointer = null;
    this.isOpen = false;
    this.element.hidden = true;
    this.viewport.editorCamera.oneFinger = true;
    this.viewport.editorCamera.enabled = true;
  };

  private readonly keyDown = (event: KeyboardEvent): void => {
    if (event.key !== 'Escape' || !this.isOpen) return;
    event.stopPropagation();
    this.cancel();
  };
}
