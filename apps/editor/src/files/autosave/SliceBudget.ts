/** Time of the page that a slice may take (ms) while there is time; a part that is begun is read to its end. */
const EASY = 1;

/** The same once a change has waited for a while. */
const LATE = 3;

/** From how long a wait on (ms) a slice may take more, and from how long on each may take twice as long as the last. */
const LATE_FROM = 250;
const VERY_LATE_FROM = 5000;

/** Parts of the first slice: code that has not run before is slow. Each slice may have twice as many as the one before. */
const FIRST = 8;

/** How much of a scene may be read at a stretch: little, unless a change has waited for long. */
export class SliceBudget {
  private parts = FIRST;
  private stretch = LATE;

  /** Reading begins. */
  begin(): void {
    this.stretch = LATE;
  }

  /** Parts that the next slice may read. */
  most(): number {
    const most = this.parts;
    this.parts *= 2;
    return most;
  }

  /**
   * Time that the next slice may take (ms).
   * @param left - of the idle moment (ms)
   * @param late - how long a change has waited (ms)
   */
  of(left: number, late: number): number {
    if (late > VERY_LATE_FROM) return (this.stretch *= 2);
    return Math.min(late > LATE_FROM ? LATE : EASY, left);
  }
}
