/** Pause between frames (ms) after which there is no frame rate. */
const IDLE_AFTER = 500;

/** Counts frames, and measures the frame rate. */
export class FrameStatistics {
  private readonly intervals = new Float64Array(30);
  private count = 0;
  private last = -Infinity;

  /** Number of frames drawn. */
  frames = 0;

  /** Records a drawn frame. @param now - ms */
  add(now: number): void {
    const interval = now - this.last;
    this.last = now;
    this.frames++;
    if (interval > IDLE_AFTER) this.count = 0;
    else this.intervals[this.count++ % this.intervals.length] = interval;
  }

  /** Frames per second over the last thirty frames; null when the last frame is too long ago. @param now - ms */
  rate(now: number): number | null {
    const known = Math.min(this.count, this.intervals.length);
    if (known < 2 || now - this.last > IDLE_AFTER) return null;
    let sum = 0;
    for (let i = 0; i < known; i++) sum += this.intervals[i];
    return (1000 * known) / sum;
  }
}
