/** Frames after an enlargement within which a reduction says that it was wrong: at first, and after a failure. */
const [FAILED, FAILED_AGAIN] = [96, 240];
/** Steps of enlargements, and of reductions, up to which they are corrections or a trial. */
const CORRECTION = 2;
/** Frames after an enlargement that has held, after which one failure is forgotten. */
const HELD = 480;
/**
 * Frames in a row that must have room for a larger scale before the next enlargement, after one failure; doubled by each
 * further failure, until an enlargement has held.
 */
const WAIT = 60;
const MOST_LEVEL = 4;

/**
 * Hysteresis for a load that comes and goes, as on a machine with other work: each time a larger scale has failed soon, the
 * next one takes room in twice as many frames in a row, which a burst of work interrupts, and is of one step. So the scale comes
 * to rest, within a few bursts, at the one that holds the budget under them; it grows again when they are over, by twice as many
 * steps each time.
 */
export class Restlessness {
  /** Failures that are remembered, 0 to `MOST_LEVEL`. */
  private level = 0;
  private sinceLarger = Infinity;
  /** Frames in a row with room for a larger scale. */
  private room = 0;
  /** Steps of the last enlargements, and of the reductions after them. */
  private larger = 0;
  private smaller = 0;
  /** Steps by which the next enlargement may go: one after a failure, twice as many after each that held. */
  stride = Infinity;

  /** Counts a frame. @param hasRoom - whether it would be in time at a larger scale, as predicted */
  count(hasRoom: boolean): void {
    this.room = hasRoom ? this.room + 1 : 0;
    if (++this.sinceLarger === HELD && this.level > 0) this.level--;
  }

  /** Whether there is evidence enough for a larger scale. */
  get mayEnlarge(): boolean {
    if (this.stride === Infinity) return true;
    return this.room >= (this.stride > 1 ? WAIT : WAIT * 2 ** Math.max(0, this.level - 1));
  }

  /** @param steps - by which the goal went higher */
  enlarged(steps: number): void {
    if (this.smaller > 0) this.larger = this.smaller = 0;
    else if (this.larger > 0) this.stride *= 2;
    this.larger += steps;
    this.sinceLarger = 0;
    this.room = 0;
  }

  /** @param steps - by which the goal went lower */
  reduced(steps: number): void {
    this.smaller += steps;
    const isEarly = this.sinceLarger < (this.level === 0 ? FAILED : FAILED_AGAIN);
    if (isEarly && this.stride < Infinity) this.stride = 1;
    if (!isEarly || Math.min(this.larger, this.smaller) <= CORRECTION || this.smaller < this.larger / 2) return;
    this.stride = 1;
    this.level = Math.min(MOST_LEVEL, this.level + 1);
    this.sinceLarger = Infinity;
  }
}
