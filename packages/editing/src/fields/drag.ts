import type { NumberRange } from './readNumber';
import { roundToStep } from './roundToStep';

/** A range of numbers as they are shown, and what they go by. */
export type SteppedRange = NumberRange & { readonly step: number };

/** Most steps of a range that has a slider; with more, a slider would be too coarse. */
const STEPS = 2048;

/** Whether a slider stands for a range: it has two ends, and not too many steps between them. */
export const suitsSlider = ({ min, max, step }: SteppedRange): boolean =>
  min !== undefined && max !== undefined && (max - min) / step <= STEPS;

/**
 * The number at a place of a slider. The ends are reached although no whole number of steps may lead there.
 * @param part - of the way from `min` to `max`; beyond 0 and 1 it is one of them
 * @param isFine - by a tenth of the step
 */
export function valueOnSlider(part: number, range: { min: number; max: number; step: number }, isFine = false): number {
  const { min, max, step } = range;
  const at = min + Math.min(Math.max(part, 0), 1) * (max - min);
  if (at <= min || at >= max) return at;
  const by = isFine ? step / 10 : step;
  return Math.min(Math.max(roundToStep(Math.round(at / by) * by, by), min), max);
}

/** A number after a drag of its label or an arrow key: within the range, rounded to the step. */
export function addToNumber(before: number, amount: number, { min, max, step }: SteppedRange): number {
  const next = roundToStep(before + amount, Math.min(step, Math.abs(amount) || step));
  return Math.min(Math.max(next, min ?? -Infinity), max ?? Infinity);
}

/** How many steps a pixel or a key is worth: 10 with Shift, a tenth with Alt. */
export const stepFactor = ({ shiftKey, altKey }: { shiftKey: boolean; altKey: boolean }): number =>
  shiftKey ? 10 : altKey ? 0.1 : 1;
