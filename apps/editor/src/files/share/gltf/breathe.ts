import { nextTask } from '../../picture/nextTask';

/** Duration of work before yielding to the page (ms). */
const SLICE = 12;

let began = 0;

/** Yields to the page when work has lasted for `SLICE` (ms); awaited between small pieces of work. */
export async function breathe(): Promise<void> {
  const now = performance.now();
  if (now - began < SLICE) return;
  await nextTask();
  began = performance.now();
}
