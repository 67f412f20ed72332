import { stepFactor } from '@farol/editing';
import { type RefObject, useEffect, useRef } from 'react';

/** What a drag to the left or right does. */
export interface Scrub {
  /** The drag begins; called once it is one, not a click. */
  begin(): void;
  /** @param pixels - since the last call @param factor - 10 with Shift, a tenth with Alt, else 1 */
  move(pixels: number, factor: number): void;
  /** @param keeps - whether what it led to shall stay */
  end(keeps: boolean): void;
  /** The button went up where it went down. */
  click(): void;
}

/** A press that moves by fewer pixels is a click. */
const SLOP = 3;

/**
 * Lets elements be dragged to the left and right. A mouse is held in its place, so that the edge of the screen is no end;
 * Escape ends the drag without effect.
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
  // no selection of text; and what is typed elsewhere is taken over
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
      // the browser takes Escape for itself
      if (wasLocked && document.pointerLockElement !== target) finish(false);
      wasLocked = document.pointerLockElement === target;
    },
    options,
  );
}

/** Holds the mouse in its place until the drag is over, where the browser can; the lock may come after that. */
function lock(target: HTMLElement, over: AbortSignal): void {
  const release = (): void => {
    if (over.aborted && document.pointerLockElement === target) document.exitPointerLock();
  };
  document.addEventListener('pointerlockchange', release, { once: true });
  // older browsers return nothing, and some refuse
  const asked = target.requestPointerLock() as Promise<void> | undefined;
  void asked?.catch(() => document.removeEventListener('pointerlockchange', release));
}
