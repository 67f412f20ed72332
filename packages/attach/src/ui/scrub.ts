import { stepFactor } from '@farol/editing';

/** Pointer movement below which a press is a click (pixels). */
const SLOP = 3;

/**
 * Makes an element draggable to the left and right; a press without a drag is still a click.
 * @param move - called with the distance so far, in steps: 1 per pixel, 10 with Shift, 0.1 with Alt
 * @param end - called at the end: true to keep the result, false after Escape
 */
export function scrub(target: HTMLElement, move: (steps: number) => void, end: (keeps: boolean) => void): void {
  target.classList.add('scrub');
  let wasDragged = false;
  target.addEventListener('click', (event) => {
    // a click after a drag would focus the label's input
    if (wasDragged) event.preventDefault();
    wasDragged = false;
  });
  target.addEventListener('pointerdown', (down) => {
    if (down.button !== 0 || !down.isPrimary) return;
    target.setPointerCapture(down.pointerId);
    const over = new AbortController();
    const options = { signal: over.signal, capture: true };
    let [lastX, steps] = [down.clientX, 0];
    wasDragged = false;
    const finish = (keeps: boolean): void => {
      over.abort();
      if (wasDragged) end(keeps);
    };
    const follow = (event: PointerEvent): void => {
      if (event.pointerId !== down.pointerId) return;
      if (!wasDragged && Math.abs(event.clientX - down.clientX) < SLOP) return;
      wasDragged = true;
      steps += (event.clientX - lastX) * stepFactor(event);
      lastX = event.clientX;
      move(steps);
    };
    const escape = (event: KeyboardEvent): void => {
      if (event.key !== 'Escape') return;
      event.preventDefault();
      event.stopPropagation();
      finish(false);
    };
    target.addEventListener('pointermove', follow, options);
    target.addEventListener('pointerup', () => finish(true), options);
    target.addEventListener('lostpointercapture', () => finish(true), options);
    target.addEventListener('pointercancel', () => finish(false), options);
    addEventListener('keydown', escape, options);
  });
}
