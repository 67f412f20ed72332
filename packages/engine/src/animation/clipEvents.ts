import type { ClipEvent } from '../assets/clips/ClipData';

/** Behaviour of a clip at its end: it stays there, begins again, or plays backwards. */
export type ClipWrap = 'once' | 'loop' | 'ping-pong';

/** Greatest number of passes of a clip for which one frame calls events. */
const MOST_PASSES = 1000;

/**
 * Position within a clip (s), for an unwrapped position, which goes on beyond the clip's ends.
 * @param seconds - unwrapped position; negative when the clip plays backwards
 * @param duration - of the clip (s)
 * @param isBackwards - at a multiple of `duration`: true returns the clip's end, false its beginning
 */
export function wrapTime(seconds: number, duration: number, wrap: ClipWrap, isBackwards = false): number {
  if (duration <= 0) return 0;
  if (wrap === 'once') return Math.min(Math.max(seconds, 0), duration);
  const period = wrap === 'loop' ? duration : 2 * duration;
  const inside = seconds - Math.floor(seconds / period) * period;
  if (wrap === 'ping-pong') return inside > duration ? period - inside : inside;
  return inside === 0 && isBackwards ? duration : Math.min(inside, duration);
}

/**
 * Calls `call` for the events between two unwrapped positions of a clip, once per pass, in playing order.
 * @param events - in order of time; those after the end of the clip are never passed
 * @param from - previous position (s, unwrapped)
 * @param to - present position (s, unwrapped), inclusive
 * @param withFrom - whether `from` is inclusive: true where the clip begins
 */
export function passEvents(
  events: readonly ClipEvent[],
  duration: number,
  wrap: ClipWrap,
  from: number,
  to: number,
  withFrom: boolean,
  call: (event: ClipEvent) => void,
): void {
  const count = events.length;
  if (count === 0 || (from === to && !withFrom)) return;
  const isPingPong = wrap === 'ping-pong';
  const period = isPingPong ? 2 * duration : duration;
  const direction = to < from ? -1 : 1;
  const isPassed = (at: number): boolean =>
    direction > 0
      ? (at > from || (withFrom && at === from)) && at <= to
      : (at < from || (withFrom && at === from)) && at >= to;
  const visit = (event: ClipEvent, at: number): void => {
    if (event.time > duration || !isPassed(at)) return;
    // the event is at the end of the pass that ends at `from`: it was called then, or the clip began after it
    const isBefore = at === from && period > 0 && event.time === (direction > 0 ? duration : 0);
    if (wrap === 'loop' && isBefore) return;
    call(event);
  };
  /** Visits one pass. `turned`: whether it is a backward pass of ping-pong, whose two ends belong to forward passes. */
  const pass = (start: number, turned: boolean): void => {
    const isFalling = turned !== direction < 0;
    for (let n = 0; n < count; n++) {
      const event = events[isFalling ? count - 1 - n : n];
      if (!turned) visit(event, start + event.time);
      else if (event.time > 0 && event.time < duration) visit(event, start + (period - event.time));
    }
  };
  if (wrap === 'once' || duration <= 0) return pass(0, false);
  const last = Math.floor(to / period);
  const first = Math.floor(from / period);
  const passes = Math.min(Math.abs(last - first), MOST_PASSES);
  // one more pass at either end, since rounding may put an event into a neighbouring pass
  for (let n = -1; n <= passes + 1; n++) {
    const start = (last - direction * (passes - n)) * period;
    if (isPingPong && direction < 0) pass(start, true);
    pass(start, false);
    if (isPingPong && direction > 0) pass(start, true);
  }
}
