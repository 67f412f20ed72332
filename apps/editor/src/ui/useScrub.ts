import { stepFactor } from '@farol/editing';
import { type RefObject, useEffect, useRef } from 'react';

/** Callbacks of a horizontal drag. */
export interface Scrub {
  /** Called when the press becomes a drag. */
  begin(): void;
  /** Called on movement. @param pixels - since the last call @param factor - 10 with Shift, 0.1 with Alt, else 1 */
  move(pixels: number, factor: number): void;
  /** Called at the end of a drag. @param keeps - whether its result is kept */
  end(keeps: boolean): void;
  /** Called when the button is released without a drag. */
  click(): void;
}

/** Movement (CSS pixels) below which a press is a click. */
const SLOP = 3;

/**
 * Makes elements draggable horizontally. The mouse pointer is locked, so that the screen's edge does not stop the drag;
 * Escape cancels.
 */
export function useScrub(
  targets: () => readonly (HTMLElement | null | undefined)[],
  scrub: Scrub,
  disabled = false,
): void {
  const latest = useRef(scrub);
  const find = useRef(targets);
  useEffect(() => {
    latest.current = scrub;
  });
  useEffect(() => {
    if (disabled) return;
    const end = new AbortController();
    for (const target of find.current()) {
      target?.addEventListener('pointerdown', (event) => press(target, event, latest), { signal: end.signal });
    }
    return () => end.abort();
  }, [disabled]);
}

function press(target: HTMLElement, down: PointerEvent, scrub: RefObject<Scrub>): void {
  if (down.button !== 0 || !down.isPrimary || (down.target as Element).closest('button, a')) return;
  // prevents text selection; the blur below commits the field that had the focus
  down.preventDefault();
  (document.activeElement as HTMLElement | null)?.blur();
  target.setPointerCapture(down.pointerId);
  const over = new AbortController();
  const options = { signal: over.signal, capture: true };
  let [lastX, total] = [down.clientX, 0];
  let [hasBegun, wasLocked] = [false, false];

  const finish = (keeps: boolean): void => {
    over.abort();
    if (document.pointerLockElement === target) document.exitPointerLock();
    if (hasBegun) scrub.current.end(keeps);
    else if (keeps) scrub.current.click();
  };
  addEventListener(
    'pointermove',
    (event) => {
      if (event.pointerId !== down.pointerId) return;
      const isLocked = document.pointerLockElement === target;
      const pixels = isLocked ? event.movementX : event.clientX - lastX;
      lastX = event.clientX;
      total += pixels;
      if (hasBegun) {
        scrub.current.move(pixels, stepFactor(event));
        return;
      }
      if (Math.abs(total) < SLOP) return;
      hasBegun = true;
      if (down.pointerType === 'mouse') lock(target, over.signal);
      scrub.current.begin();
      scrub.current.move(total, stepFactor(event));
    },
    options,
  );
  addEventListener('pointerup', (event) => event.pointerId === down.pointerId && finish(true), options);
  addEventListener('pointercancel', (event) => event.pointerId === down.pointerId && finish(false), options);
  addEventListener('blur', (event) => event.target === window && finish(false), options);
  addEventListener(
    'keydown',
    (event) => {
      if (event.key !== 'Escape') return;
      event.preventDefault();
      event.stopPropagation();
      finish(false);
    },
    options,
  );
  document.addEventListener(
    'pointerlockchange',
    () => {
      // pressing Escape ends the pointer lock, without a key event
      if (wasLocked && document.pointerLockElement !== target) finish(false);
      wasLocked = document.pointerLockElement === target;
    },
    options,
  );
}

/** Locks the pointer until the drag is over, where supported; a lock granted after that is released at once. */
function lock(target: HTMLElement, over: AbortSignal): void {
  const release = (): void => {
    if (over.aborted && document.pointerLockElement === target) document.exitPointerLock();
  };
  document.addEventListener('pointerlockchange', release, { once: true });
  // older browsers return no promise; others reject when the lock is refused
  const asked = target.requestPointerLock() as Promise<void> | undefined;
  void asked?.catch(() => document.removeEventListener('pointerlockchange', release));
}
