/** Number of frames after an enlargement within which a reduction means that it failed: at first, and after a failure. */
const [FAILED, FAILED_AGAIN] = [96, 240];
/** Maximum number of steps of an enlargement or reduction that is a mere correction or trial, not a failure. */
const CORRECTION = 3;
/** Number of frames that an enlargement must hold until failures are forgotten. */
const HELD = 480;
/** Number of last frames, and the share of them, that a larger scale must suit after a failure. */
const FRAMES = 480;
const SHARE = 0.95;
/** Number of steps above which, after a failure, a larger scale is worth a change. */
const WORTH = 3;
/** Maximum number of steps of scale. */
const STEPS = 64;

/**
 * Hysteresis for a load that comes and goes, as on a machine with other work: once a larger scale has failed quickly, the scale
 * grows only to one that would have suited nearly all of the last frames, bursts of load included. It stays at the scale that
 * holds the budget during bursts, and grows in one go some seconds after the last burst.
 */
export class Restlessness {
  /** Whether a larger scale has failed and no enlargement has lasted since. */
  isRestless = false;
  private sinceLarger = Infinity;
  /** Number of steps of the last enlargements, and of the reductions after them. */
  private larger = 0;
  private smaller = 0;
  /** Step that each of the last frames needed, and the number of frames that needed each step. */
  private readonly needed = new Uint8Array(FRAMES);
  private readonly counts = new Uint16Array(STEPS + 1);
  private added = 0;

  /** Counts a frame. @param step - step at which it would have met its budget, counted from the largest scale down */
  count(step: number): void {
    if (++this.sinceLarger === HELD) this.isRestless = false;
    const { needed, counts } = this;
    const at = this.added++ % FRAMES;
    if (this.added > FRAMES) counts[needed[at]]--;
    needed[at] = Math.min(STEPS, step);
    counts[needed[at]]++;
  }

  /** Least step (largest scale) allowed as a goal from a step; the step itself where no larger scale may be tried. */
  leastFrom(step: number): number {
    if (!this.isRestless) return 0;
    if (this.added < FRAMES) return step;
    let above = FRAMES * (1 - SHARE);
    let least = STEPS;
    while (least > 0 && (above -= this.counts[least]) > 0) least--;
    return least < step - WORTH ? least : step;
  }

  /** @param steps - number of steps by which the goal's scale grew */
  enlarged(steps: number): void {
    if (this.smaller > 0) this.larger = this.smaller = 0;
    this.larger += steps;
    this.sinceLarger = 0;
  }

  /** @param steps - number of steps by which the goal's scale shrank */
  reduced(steps: number): void {
    this.smaller += steps;
    const isEarly = this.sinceLarger < (this.isRestless ? FAILED_AGAIN : FAILED);
    if (!isEarly || Math.min(this.larger, this.smaller) <= CORRECTION || this.smaller < this.larger / 2) return;
    this.isRestless = true;
    this.sinceLarger = Infinity;
  }
}
