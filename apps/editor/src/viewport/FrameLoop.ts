/** What a loop asks for in each turn of the page. */
export interface FrameWork {
  /** Lets time pass. @param seconds - since the last turn; 0 at first @returns whether a frame is to be drawn */
  advance(seconds: number): boolean;
  draw(): void;
  /** Takes what `draw` throws. */
  failed(error: unknown): void;
  /** Called in place of `draw` while nothing changes. */
  rest(): void;
}

/** Draws the frames that are asked for, one in each turn of the page at most. */
export class FrameLoop {
  /** Whether every frame is drawn, changed or not. */
  continuous = false;

  /** Frames that are still to be drawn. */
  private pending = 1;
  private request = 0;
  /** When the last turn was (ms); 0 before the first. */
  private last = 0;

  constructor(private readonly work: FrameWork) {}

  /** Begins, and goes on until `stop`. */
  start(): void {
    this.request = requestAnimationFrame(this.turn);
  }

  stop(): void {
    cancelAnimationFrame(this.request);
  }

  /** Has frames drawn, the next one first. */
  ask(frames: number): void {
    this.pending = frames;
  }

  private readonly turn = (now: number): void => {
    this.start();
    const seconds = this.last === 0 ? 0 : (now - this.last) / 1000;
    this.last = now;
    const isNeeded = this.work.advance(seconds);
    if (!isNeeded && !this.continuous && this.pending === 0) return this.work.rest();
    this.pending = Math.max(0, this.pending - 1);
    try {
      this.work.draw();
    } catch (error) {
      this.work.failed(error);
    }
  };
}
