/** Duration of a slice (ms) while changes are recent; a part that was begun is read to its end. */
const EASY = 1;

/** Duration of a slice (ms) once a change has waited for `LATE_FROM`. */
const LATE = 3;

/** Waiting times of a change (ms) from which slices last `LATE`, and from which each is twice as long as the last. */
const LATE_FROM = 250;
const VERY_LATE_FROM = 5000;

/**
 * Number of parts in the first slice: code that runs for the first time is slow. Each slice may have twice as many as
 * the one before.
 */
const FIRST = 8;

/** Limits how much of a scene is read in one slice: little, unless a change has waited for long. */
export class SliceBudget {
  private parts = FIRST;
  private stretch = LATE;

  /** Called when reading begins: resets the duration of slices. */
  begin(): void {
    this.stretch = LATE;
  }

  /** Number of parts that the next slice may read. */
  most(): number {
    const most = this.parts;
    this.parts *= 2;
    return most;
  }

  /**
   * Duration of the next slice (ms).
   * @param left - rest of the idle period (ms)
   * @param late - time since the oldest unread change (ms)
   */
  of(left: number, late: number): number {
    if (late > VERY_LATE_FROM) return (this.stretch *= 2);
    return Math.min(late > LATE_FROM ? LATE : EASY, left);
  }
}
