import { isTyping } from '@farol/editing';
import type { EngineKeyEvent, EnginePointerEvent } from '../core/events';

/** Receiver of the routed pointer and key events. */
export interface InputSink {
  dispatchPointer(event: EnginePointerEvent): void;
  dispatchKey(event: EngineKeyEvent): void;
}

/** Part of a canvas that InputRouter uses. */
export interface InputSurface extends EventTarget {
  getBoundingClientRect(): { left: number; top: number; width: number; height: number };
  setPointerCapture?(pointerId: number): void;
}

/** Pixels per unit of a wheel event, by its `deltaMode`: pixels, lines, pages. */
const WHEEL_UNITS = [1, 16, 400];

const pointerTypeOf = ({ pointerType }: PointerEvent): 'mouse' | 'touch' | 'pen' =>
  pointerType === 'touch' || pointerType === 'pen' ? pointerType : 'mouse';

/**
 * Turns a canvas's pointer events and a page's key events into the engine's, and passes them on. Ignores keys typed
 * into text fields. Releases all keys when the page loses focus or Command is released: macOS sends no keyup for keys
 * released while Command is held.
 */
export class InputRouter {
  private readonly abort = new AbortController();
  private readonly held = new Map<string, KeyboardEvent>();
  private readonly pointers = new Map<number, { x: number; y: number }>();

  /**
   * @param surface - the canvas
   * @param keys - target that gets the key listeners, such as the window; null for none
   */
  constructor(
    private readonly surface: InputSurface,
    keys: EventTarget | null,
    private readonly sink: InputSink,
  ) {
    const { signal } = this.abort;
    const pointer = (type: EnginePointerEvent['type']) => (event: Event) => this.pointer(type, event as PointerEvent);
    surface.addEventListener('pointerdown', pointer('down'), { signal });
    surface.addEventListener('pointermove', pointer('move'), { signal });
    surface.addEventListener('pointerup', pointer('up'), { signal });
    surface.addEventListener('pointerleave', pointer('leave'), { signal });
    const cancelled = (event: Event): void => {
      this.pointer('leave', event as PointerEvent);
      this.pointer('up', event as PointerEvent);
    };
    surface.addEventListener('pointercancel', cancelled, { signal });
    surface.addEventListener('wheel', pointer('wheel'), { signal, passive: false });
    surface.addEventListener('contextmenu', (event) => event.preventDefault(), { signal });
    keys?.addEventListener('keydown', (event) => this.keyDown(event as KeyboardEvent), { signal });
    keys?.addEventListener('keyup', (event) => this.keyUp(event as KeyboardEvent), { signal });
    keys?.addEventListener('blur', () => this.releaseKeys(), { signal });
  }

  /** Releases every held key. */
  releaseKeys(): void {
    for (const event of [...this.held.values()]) this.keyUp(event);
  }

  /** Removes the listeners from canvas and window. */
  dispose(): void {
    this.releaseKeys();
    this.abort.abort();
  }

  private pointer(type: EnginePointerEvent['type'], event: PointerEvent): void {
    const bounds = this.surface.getBoundingClientRect();
    const [x, y] = [event.clientX - bounds.left, event.clientY - bounds.top];
    const last = this.pointers.get(event.pointerId) ?? { x, y };
    if (type === 'down') this.surface.setPointerCapture?.(event.pointerId);
    if (type === 'wheel') event.preventDefault();
    if (type === 'up' && event.pointerType === 'touch') this.pointers.delete(event.pointerId);
    else if (type !== 'wheel' && type !== 'leave') this.pointers.set(event.pointerId, { x, y });
    const wheelEvent = event as unknown as WheelEvent;
    this.sink.dispatchPointer({
      type,
      x,
      y,
      dx: type === 'move' ? x - last.x : 0,
      dy: type === 'move' ? y - last.y : 0,
      ndcX: bounds.width > 0 ? (x / bounds.width) * 2 - 1 : 0,
      ndcY: bounds.height > 0 ? 1 - (y / bounds.height) * 2 : 0,
      button: event.button ?? -1,
      buttons: event.buttons ?? 0,
      pointerId: event.pointerId ?? 0,
      pointerType: pointerTypeOf(event),
      wheel: type === 'wheel' ? wheelEvent.deltaY * (WHEEL_UNITS[wheelEvent.deltaMode] ?? 1) : 0,
      shiftKey: event.shiftKey,
      ctrlKey: event.ctrlKey,
      altKey: event.altKey,
      metaKey: event.metaKey,
    });
  }

  private keyDown(event: KeyboardEvent): void {
    if (isTyping(event) || event.defaultPrevented) return;
    this.held.set(event.code, event);
    this.key('down', event);
  }

  private keyUp(event: KeyboardEvent): void {
    if (this.held.delete(event.code)) this.key('up', event);
    if (event.key === 'Meta') this.releaseKeys();
  }

  private key(type: EngineKeyEvent['type'], event: KeyboardEvent): void {
    const { code, key, repeat, shiftKey, ctrlKey, altKey, metaKey } = event;
    this.sink.dispatchKey({ type, code, key, repeat, shiftKey, ctrlKey, altKey, metaKey });
  }
}
