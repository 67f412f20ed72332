/** Time for which a long loop may run before other tasks of the page have their turn (ms). */
const SLICE = 20;

/** Cuts a long loop into slices: the page answers between them, and may cancel the work. */
export class Slices {
  private end = performance.now() + SLICE;

  /** @param signal - cancels the work between two slices */
  constructor(private readonly signal?: AbortSignal) {}

  /** Whether it is time for `next`; ask every few thousand steps. */
  get areOver(): boolean {
    return performance.now() > this.end;
  }

  /** Lets others have their turn. @throws what the signal was aborted with */
  async next(): Promise<void> {
    const { scheduler } = globalThis as { scheduler?: { yield?(): Promise<void> } };
    await (scheduler?.yield?.() ?? new Promise((resolve) => setTimeout(resolve)));
    this.signal?.throwIfAborted();
    this.end = performance.now() + SLICE;
  }
}
