/** Frames after an enlargement within which a reduction says that it was wrong: at first, and after a failure. */
const [FAILED, FAILED_AGAIN] = [96, 240];
/** Maximum steps of an enlargement or a reduction that counts as a correction or a trial. */
const CORRECTION = 3;
/** Number of frames that an enlargement must hold until failures are forgotten. */
const HELD = 480;
/** Frames that a larger scale must suit after a failure, and the share of them that it must suit. */
const FRAMES = 480;
const SHARE = 0.95;
/** Steps above which a larger scale is worth a change then. */
const WORTH = 3;
/** Maximum number of steps of scale. */
const STEPS = 64;

/**
 * Hysteresis for a load that comes and goes, as on a machine with other work: once a larger scale has failed soon, the scale
 * grows only to one that would have suited nearly all of the last frames, those of bursts among them. So it rests at the one
 * that holds the budget under the bursts, and grows again, in one go, some seconds after they are over.
 */
export class Restlessness {
  /** Whether a larger scale has failed, and none has held since. */
  isRestless = false;
  private sinceLarger = Infinity;
  /** Steps of the last enlargements, and of the reductions after them. */
  private larger = 0;
  private smaller = 0;
  /** Step that each of the last frames needed, and how many of them needed each. */
  private readonly needed = new Uint8Array(FRAMES);
  private readonly counts = new Uint16Array(STEPS + 1);
  private added = 0;

  /** Counts a frame. @param step - at which it would have been in time, in steps below the largest scale */
  count(step: number): void {
    if (++this.sinceLarger === HELD) this.isRestless = false;
    const { needed, counts } = this;
    const at = this.added++ % FRAMES;
    if (this.added > FRAMES) counts[needed[at]]--;
    needed[at] = Math.min(STEPS, step);
    counts[needed[at]]++;
  }

  /** Least step that may be gone to from a step: itself, where no larger scale may be tried. */
  leastFrom(step: number): number {
    if (!this.isRestless) return 0;
    if (this.added < FRAMES) return step;
    let above = FRAMES * (1 - SHARE);
    let least = STEPS;
    while (least > 0 && (above -= this.counts[least]) > 0) least--;
    return least < step - WORTH ? least : step;
  }

  /** @param steps - by which the goal went higher */
  enlarged(steps: number): void {
    if (this.smaller > 0) this.larger = this.smaller = 0;
    this.larger += steps;
    this.sinceLarger = 0;
  }

  /** @param steps - by which the goal went lower */
  reduced(steps: number): void {
    this.smaller += steps;
    const isEarly = this.sinceLarger < (this.isRestless ? FAILED_AGAIN : FAILED);
    if (!isEarly || Math.min(this.larger, this.smaller) <= CORRECTION || this.smaller < this.larger / 2) return;
    this.isRestless = true;
    this.sinceLarger = Infinity;
  }
}
