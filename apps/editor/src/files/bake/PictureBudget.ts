/** Smallest time between two frames during a bake (ms). */
const LEAST = 250;
/** Largest share of the time spent drawing frames. */
const SHARE = 0.2;

/** Decides when to draw a frame during a bake, so that slow devices spend most of the time tracing. */
export class PictureBudget {
  private next = 0;
  private drawnAt: number | null = null;

  /** @param now - time (ms) after a part of the bake; a frame that is due must be drawn before the next call */
  isDue(now: number): boolean {
    if (this.drawnAt !== null) {
      const cost = now - this.drawnAt;
      this.next = now + Math.max(LEAST - cost, cost * (1 / SHARE - 1));
      this.drawnAt = null;
    }
    if (now < this.next) return false;
    this.drawnAt = now;
    return true;
  }
}
