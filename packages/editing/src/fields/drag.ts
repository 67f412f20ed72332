import type { NumberRange } from './readNumber';
import { roundToStep } from './roundToStep';

/** Range and step of a number as displayed. */
export type SteppedRange = NumberRange & { readonly step: number };

/** Greatest number of steps in a range that gets a slider; with more, a slider would be too coarse. */
const STEPS = 2048;

/** Whether a range gets a slider: it has both limits, and not too many steps between them. */
export const suitsSlider = ({ min, max, step }: SteppedRange): boolean =>
  min !== undefined && max !== undefined && (max - min) / step <= STEPS;

/**
 * Number at a position of a slider. Both limits can be reached, even if the range is not a multiple of the step.
 * @param part - position from `min` (0) to `max` (1); clamped
 * @param isFine - rounds to a tenth of the step
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

/** Factor on steps for modifier keys: 10 with Shift, a tenth with Alt. */
export const stepFactor = ({ shiftKey, altKey }: { shiftKey: boolean; altKey: boolean }): number =>
  shiftKey ? 10 : altKey ? 0.1 : 1;
