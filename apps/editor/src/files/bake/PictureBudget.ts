/** Time between two pictures of a bake, at least (ms). */
const LEAST = 250;
/** Share of the time that pictures may take. */
const SHARE = 0.2;

/** When the picture is to be drawn while light is baked: so that a slow device traces light most of the time. */
export class PictureBudget {
  private next = 0;
  private drawnAt: number | null = null;

  /** @param now - (ms) when a part of the bake was done; a picture that was due is drawn before the next call */
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
