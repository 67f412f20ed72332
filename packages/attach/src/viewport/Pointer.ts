import { Vector2 } from 'three';
import type { Session } from '../model/Session';
import type { Gizmo } from './Gizmo';
import { locate } from './locate';
import { pickObject } from './pickObject';

/** Greatest movement of the pointer during a click (CSS pixels). */
const CLICK = 4;

/**
 * Pointer on the page's canvas: drags the gizmo, and selects clicked objects; Ctrl or Shift adds to the selection. The
 * page's own controls get all events that the gizmo does not use.
 */
export class Pointer {
  private readonly at = new Vector2();
  private pressed: { x: number; y: number; id: number } | null = null;
  private readonly listening = new AbortController();

  /** @param area - element on which the page's controls listen */
  constructor(
    private readonly session: Session,
    private readonly gizmo: Gizmo,
    private readonly area: HTMLElement,
  ) {
    const options = { capture: true, signal: this.listening.signal };
    addEventListener('pointermove', (event) => this.move(event), options);
    addEventListener('pointerdown', (event) => this.down(event), options);
    addEventListener('pointerup', (event) => this.up(event, true), options);
    addEventListener('pointercancel', (event) => this.up(event, false), options);
    addEventListener('keydown', (event) => this.escape(event), options);
  }

  dispose(): void {
    if (this.gizmo.isDragging) this.gizmo.finish(this.at, false);
    this.listening.abort();
  }

  private down(event: PointerEvent): void {
    if (event.button !== 0 || !this.isOver(event)) return;
    if (this.gizmo.hover(this.at)) {
      this.gizmo.begin(this.at);
      take(event);
    } else {
      this.pressed = { x: event.clientX, y: event.clientY, id: event.pointerId };
    }
  }

  private move(event: PointerEvent): void {
    if (this.gizmo.isDragging) {
      this.locate(event);
      this.gizmo.drag(this.at);
      take(event);
    } else if (event.buttons === 0 && this.isOver(event)) {
      this.gizmo.hover(this.at);
    }
  }

  private up(event: PointerEvent, keep: boolean): void {
    this.locate(event);
    if (this.gizmo.isDragging) {
      this.gizmo.finish(this.at, keep);
      take(event);
      return;
    }
    const { pressed, session } = this;
    this.pressed = null;
    if (!pressed || pressed.id !== event.pointerId || !keep) return;
    if (Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) > CLICK) return;
    const picked = pickObject(session.scene, session.camera, this.at);
    if (!event.ctrlKey && !event.metaKey && !event.shiftKey) session.select(picked);
    else if (picked) session.selection.toggle(picked);
  }

  private escape(event: KeyboardEvent): void {
    if (event.key !== 'Escape' || !this.gizmo.isDragging) return;
    this.gizmo.finish(this.at, false);
    take(event);
  }

  /** Locates the pointer. @returns whether it is within the session camera's viewport */
  private isOver(event: PointerEvent): boolean {
    if (event.target !== this.area && event.target !== this.session.webgl.domElement) return false;
    this.locate(event);
    return Math.max(Math.abs(this.at.x), Math.abs(this.at.y)) <= 1;
  }

  /** Sets `at` to the pointer's position in normalised device coordinates. */
  private locate(event: PointerEvent): void {
    locate(this.session.webgl.domElement, this.session.view, event, this.at);
  }
}

/** Stops an event from reaching the page. */
function take(event: Event): void {
  event.stopImmediatePropagation();
  event.preventDefault();
}
