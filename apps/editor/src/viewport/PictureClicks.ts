import { Vector2 } from 'three';
import type { Viewport } from './Viewport';

/** Movement (CSS pixels) that makes a press a drag of the camera, not a click. */
const CLICK_REACH = 4;

/** Reports clicks on the picture to a tool, in place of selecting objects; drags still move the camera. */
export class PictureClicks {
  private readonly from = new Vector2();
  private pointer: number | null = null;

  /** @param clicked - called with a point of the page (CSS pixels) */
  constructor(
    private readonly viewport: Viewport,
    private readonly clicked: (x: number, y: number) => Promise<void>,
  ) {
    const { canvas, gizmo } = viewport;
    canvas.addEventListener('pointerdown', this.pointerDown, true);
    canvas.addEventListener('pointerup', this.pointerUp, true);
    gizmo.suspended = true;
    viewport.boxSelect.cancel();
    canvas.classList.add('measuring');
  }

  end(): void {
    const { canvas, gizmo } = this.viewport;
    canvas.removeEventListener('pointerdown', this.pointerDown, true);
    canvas.removeEventListener('pointerup', this.pointerUp, true);
    canvas.classList.remove('measuring');
    gizmo.suspended = false;
  }

  private readonly pointerDown = (event: PointerEvent): void => {
    this.pointer = event.button === 0 && event.isPrimary ? event.pointerId : null;
    this.from.set(event.clientX, event.clientY);
  };

  private readonly pointerUp = (event: PointerEvent): void => {
    if (event.pointerId !== this.pointer) return;
    this.pointer = null;
    // clicks must not select
    this.viewport.picker.cancel();
    if (Math.hypot(event.clientX - this.from.x, event.clientY - this.from.y) > CLICK_REACH) return;
    this.clicked(event.clientX, event.clientY).catch((error) => this.viewport.onError(error));
  };
}
