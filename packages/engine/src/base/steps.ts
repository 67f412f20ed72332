import type { Slices } from './Slices';

/** Elements processed per step: about a millisecond of work. */
const STEP = 8192;

/** A long computation that yields after each step; its return value is the result. */
export type Steps<T> = Generator<void, T, void>;

/** Runs a loop over `count` elements in steps. @param run - processes elements `from` to `to` - 1 */
export function* inSteps(count: number, run: (from: number, to: number) => void): Steps<void> {
  for (let from = 0; from < count; from += STEP) {
    run(from, Math.min(count, from + STEP));
    yield;
  }
}

export function runSteps<T>(steps: Steps<T>): T {
  for (;;) {
    const step = steps.next();
    if (step.done) return step.value;
  }
}

/**
 * Runs a computation in slices, between which the page stays responsive.
 * @throws the abort reason of `slices`
 */
export async function runInSlices<T>(steps: Steps<T>, slices: Slices): Promise<T> {
  for (;;) {
    const step = steps.next();
    if (step.done) return step.value;
    if (slices.areOver) await slices.next();
  }
}
