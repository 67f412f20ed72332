import { Vector2 } from 'three';
import type { Viewport } from './Viewport';

/** Time (ms) that a finger must rest to open the menu. */
const LONG = 500;
/** Movement (CSS pixels) that makes a press a drag instead. */
const REACH = { mouse: 4, finger: 8 };

/**
 * Opens the viewport's context menu on a right click or a long press, after selecting the object there. Does nothing
 * while a finger orbits, pans or drags a handle, while flying with keys, or while input goes to the scene.
 */
export class MenuPress {
  private readonly from = new Vector2();
  private readonly to = new Vector2();
  private readonly end = new AbortController();
  private pointer: number | null = null;
  private reach = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;

  /** @param open - opens the menu for the selection, at a point of the page (CSS pixels) */
  constructor(
    private readonly viewport: Viewport,
    private readonly open: (x: number, y: number) => void,
  ) {
    const { canvas } = viewport;
    const { signal } = this.end;
    canvas.addEventListener('pointerdown', this.pointerDown, { signal });
    canvas.addEventListener('pointermove', this.pointerMove, { signal });
    canvas.addEventListener('pointerup', this.pointerUp, { signal });
    canvas.addEventListener('pointercancel', this.cancel, { signal });
  }

  dispose(): void {
    this.cancel();
    this.end.abort();
  }

  private readonly pointerDown = (event: PointerEvent): void => {
    this.cancel(); // a second finger cancels the long press too
    const isMouse = event.pointerType === 'mouse';
    if (event.button !== (isMouse ? 2 : 0) || !event.isPrimary || this.viewport.sceneListens) return;
    this.pointer = event.pointerId;
    this.reach = isMouse ? REACH.mouse : REACH.finger;
    this.from.set(event.clientX, event.clientY);
    if (!isMouse) this.timer = setTimeout(this.rested, LONG);
  };

  private readonly pointerMove = (event: PointerEvent): void => {
    if (event.pointerId !== this.pointer) return;
    if (this.from.distanceTo(this.to.set(event.clientX, event.clientY)) > this.reach) this.cancel();
  };

  private readonly pointerUp = (event: PointerEvent): void => {
    if (event.pointerId !== this.pointer) return;
    const clicks = event.pointerType === 'mouse' && !this.viewport.editorCamera.fly?.flew;
    this.cancel();
    if (clicks && !this.viewport.gizmo.isDragging) this.fire();
  };

  private readonly rested = (): void => {
    this.cancel();
    const { viewport } = this;
    if (viewport.gizmo.isHot) return;
    this.fire();
    // after the menu has opened, the finger must not select or drag
    viewport.picker.cancel();
    viewport.boxSelect.cancel();
    viewport.editorCamera.enabled = false;
    viewport.editorCamera.enabled = true;
  };

  private readonly cancel = (): void => {
    clearTimeout(this.timer);
    this.pointer = null;
  };

  private fire(): void {
    const { selection } = this.viewport.document;
    const { x, y } = this.from;
    const object = this.viewport.picker.objectAt(x, y);
    if (object === null) selection.clear();
    else if (!selection.has(object.id)) selection.set([object.id]);
    this.open(x, y);
  }
}
