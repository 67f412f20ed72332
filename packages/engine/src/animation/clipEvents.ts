import type { ClipEvent } from '../assets/clips/ClipData';

/** Behaviour of a clip at its end: it stays there, begins again, or plays backwards. */
export type ClipWrap = 'once' | 'loop' | 'ping-pong';

/** Greatest number of passes of a clip for which one frame calls events. */
const MOST_PASSES = 1000;

/**
 * The time within a clip.
 * @param seconds - since its beginning, as if it had no end; below 0 where it runs backwards
 * @param duration - of the clip (s)
 * @param isBackwards - true: the end counts as the end; false: as the beginning of the next pass
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
 * Finds the events that a clip passes on its way, each once in each pass, in the order they are passed in.
 * @param events - in order of time; those after the end of the clip are never passed
 * @param from - seconds as of `wrapTime`
 * @param to - present position; an event exactly there is passed
 * @param withFrom - whether one exactly at `from` is passed too: where the clip begins
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
    // before the first pass there is no end of an earlier one
    const isBefore = at === from && period > 0 && event.time === (direction > 0 ? duration : 0);
    if (wrap === 'loop' && isBefore) return;
    call(event);
  };
  /** One way through the clip; `turned` is the way back of ping-pong, without its two ends. */
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
  // one loop of the clip more at each end, for events that rounding puts into a neighbouring one
  for (let n = -1; n <= passes + 1; n++) {
    const start = (last - direction * (passes - n)) * period;
    if (isPingPong && direction < 0) pass(start, true);
    pass(start, false);
    if (isPingPong && direction > 0) pass(start, true);
  }
}
