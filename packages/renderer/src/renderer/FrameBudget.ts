/** Time that a frame may take, and the scales (share of the picture's width and height) allowed to hold that time. */
export interface FrameBudget {
  /** Milliseconds a frame, above 0: 16.7 for 60 frames a second. */
  readonly frame: number;
  /** Smallest scale, 0.25 to `max`. Default 0.5. */
  readonly min?: number;
  /** Largest scale, up to 1. Default 1. */
  readonly max?: number;
  /** Sharpening of the enlarged picture, 0 (none) to 1. Default 0.2. */
  readonly sharpness?: number;
}

/** Source of the frame times that a budget reads: the GPU's timer, or intervals between frames. */
export type BudgetSource = 'gpu' | 'interval';

/** State of the frame budget in the last frame. */
export interface BudgetInfo {
  /** Side of the drawn scene as a share of the picture's; 1 where nothing is enlarged. */
  scale: number;
  /** Sentence on why the scale is what it is. */
  reason: string;
  /** Median time of the last frames (ms); null before the first time is known. */
  ms: number | null;
  source: BudgetSource;
}

const DEFAULTS = { min: 0.5, max: 1, sharpness: 0.2 };

/** @returns the budget with defaults filled in @throws RangeError that names a value out of range */
export function checkBudget(budget: FrameBudget): Required<FrameBudget> {
  const all: Required<FrameBudget> = { ...DEFAULTS, ...budget };
  const { frame, min, max, sharpness } = all;
  const wrong =
    !(frame > 0 && frame < Infinity) ? 'give a frame above 0 ms'
    : !(max >= 0.25 && max <= 1) ? 'give a max from 0.25 to 1'
    : !(min >= 0.25 && min <= max) ? 'give a min from 0.25 to max'
    : !(sharpness >= 0 && sharpness <= 1) ? 'give a sharpness from 0 to 1' : null; // prettier-ignore
  if (wrong !== null)
    throw new RangeError(
      `FarolRenderer: budget is { frame: ${frame}, min: ${min}, max: ${max}, sharpness: ${sharpness} }; ${wrong}.`,
    );
  return all;
}
