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

/** The smallest of 1, 2, 5, 10, 20 and so on that is not below a number. */
function niceAbove(least: number): number {
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
