import { formatNumber } from '@farol/editing';

/** What the marks of a ruler are: every so many of them with a number. */
export interface RulerSteps {
  /** Seconds between two marks. */
  readonly step: number;
  /** Marks from one number to the next. */
  readonly perLabel: number;
  /** Which mark a time is at is written so. */
  labelOf(time: number): string;
}

/** Room that a number needs (CSS pixels). */
const LABEL = 56;

const NICE = [1, 2, 5] as const;

/** Marks that a ruler has at most: more than pixels of any screen have room for. */
const MOST_MARKS = 2000;

/**
 * The marks of a ruler from one place up to another, as multiples of its step. None where there would be very many, or
 * where numbers have no digits left to tell one from the next.
 */
export function marksBetween(from: number, to: number, step: number): number[] {
  const first = Math.ceil(from / step);
  const count = Math.floor(to / step) - first + 1;
  if (!(count > 0 && count <= MOST_MARKS) || !Number.isSafeInteger(first) || !Number.isSafeInteger(first + count))
    return [];
  return Array.from({ length: count }, (_, i) => first + i);
}

/** The smallest of 1, 2, 5, 10, 20 and so on that is not below a number. */
function niceAbove(least: number): number {
  if (!(least > 1e-100 && least < 1e100)) return 1;
  for (let power = 10 ** Math.floor(Math.log10(least)); ; power *= 10) {
    for (const factor of NICE) if (factor * power >= least * 0.999) return factor * power;
  }
}

/** @param scale - CSS pixels a second */
export function rulerSteps(scale: number, frameRate: number, unit: 'seconds' | 'frames'): RulerSteps {
  if (unit === 'frames') {
    const frames = Math.max(niceAbove(Math.max((LABEL * frameRate) / scale, 1)), 1);
    const perLabel = frames % 5 === 0 ? 5 : frames % 2 === 0 ? 2 : 1;
    return {
      step: frames / frameRate / perLabel,
      perLabel,
      labelOf: (time) => String(Math.round(time * frameRate)),
    };
  }
  const seconds = niceAbove(LABEL / scale);
  const perLabel = 5;
  return { step: seconds / perLabel, perLabel, labelOf: (time) => formatNumber(time, 'short') };
}

/** A time as the panel writes it: '1.20 s', or 'frame 36'. */
export const timeText = (time: number, frameRate: number, unit: 'seconds' | 'frames'): string =>
  unit === 'frames' ? String(Math.round(time * frameRate)) : time.toFixed(2);
