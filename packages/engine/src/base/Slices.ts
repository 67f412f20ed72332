/** Longest time (ms) that a loop runs before it yields to other tasks of the page. */
const SLICE = 20;

/** Splits a long loop into slices; between them the page stays responsive and may cancel the work. */
export class Slices {
  private end = performance.now() + SLICE;

  /** @param signal - cancels the work between two slices */
  constructor(private readonly signal?: AbortSignal) {}

  /** Whether the present slice is over and `next` is due; check every few thousand steps. */
  get areOver(): boolean {
    return performance.now() > this.end;
  }

  /** Yields to other tasks of the page. @throws the signal's abort reason */
  async next(): Promise<void> {
    const { scheduler } = globalThis as { scheduler?: { yield?(): Promise<void> } };
    await (scheduler?.yield?.() ?? new Promise((resolve) => setTimeout(resolve)));
    this.signal?.throwIfAborted();
    this.end = performance.now() + SLICE;
  }
}
