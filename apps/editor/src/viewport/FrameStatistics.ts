/** A picture that stands still for longer than this (ms) has no frame rate. */
const IDLE_AFTER = 500;

/** How often frames are drawn. */
export class FrameStatistics {
  private readonly intervals = new Float64Array(30);
  private count = 0;
  private last = -Infinity;

  /** Frames drawn in all. */
  frames = 0;

  /** A frame was drawn. @param now - ms */
  add(now: number): void {
    const interval = now - this.last;
    this.last = now;
    this.frames++;
    if (interval > IDLE_AFTER) this.count = 0;
    else this.intervals[this.count++ % this.intervals.length] = interval;
  }

  /** Frames a second over the last thirty frames; null while the picture stands still. @param now - ms */
  rate(now: number): number | null {
    const known = Math.min(this.count, this.intervals.length);
    if (known < 2 || now - this.last > IDLE_AFTER) return null;
    let sum = 0;
    for (let i = 0; i < known; i++) sum += this.intervals[i];
    return (1000 * known) / sum;
  }
}
