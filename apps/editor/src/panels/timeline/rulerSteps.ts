import { formatNumber } from '@farol/editing';

/** Spacing and labels of a ruler's marks. */
export interface RulerSteps {
  /** Time between two marks (s). */
  readonly step: number;
  /** Number of marks from one label to the next. */
  readonly perLabel: number;
  /** Text of the label at a time (s). */
  labelOf(time: number): string;
}

/** Space for a label (CSS pixels). */
const LABEL = 56;

const NICE = [1, 2, 5] as const;

/** Maximum number of marks, more than fit on any screen. */
const MOST_MARKS = 2000;

/**
 * Marks of a ruler in a range, as multiples of its step. None when there would be too many, or when the step is below
 * floating-point resolution.
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

/** Chooses a ruler's marks and labels for a scale. @param scale - CSS pixels per second */
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

/** Text of a time: '1.20' in seconds, '36' in frames. */
export const timeText = (time: number, frameRate: number, unit: 'seconds' | 'frames'): string =>
  unit === 'frames' ? String(Math.round(time * frameRate)) : time.toFixed(2);
