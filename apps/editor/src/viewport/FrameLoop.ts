/** Work that a FrameLoop does in each animation frame. */
export interface FrameWork {
  /** Advances time. @param seconds - since the last animation frame; 0 at first @returns whether to draw a frame */
  advance(seconds: number): boolean;
  draw(): void;
  /** Number of frames that a request needs; read again after each frame, since it may become smaller. */
  frames(): number;
  /** Called with an error that `draw` has thrown. */
  failed(error: unknown): void;
  /** Called instead of `draw` while nothing changes. */
  rest(): void;
}

/** Draws requested frames, at most one per animation frame. */
export class FrameLoop {
  /** Whether every frame is drawn, requested or not. */
  continuous = false;

  /** Number of frames still to be drawn; grows while the loop is stopped too. */
  pending = 1;
  private request = 0;
  /** Time of the last animation frame (ms); 0 before the first. */
  private last = 0;

  constructor(private readonly work: FrameWork) {}

  /** Starts the loop, which runs until `stop`. */
  start(): void {
    this.request = requestAnimationFrame(this.turn);
  }

  stop(): void {
    cancelAnimationFrame(this.request);
  }

  /** Requests frames. @param frames - number of frames to draw, starting with the next */
  ask(frames: number): void {
    this.pending = frames;
  }

  private readonly turn = (now: number): void => {
    this.start();
    const seconds = this.last === 0 ? 0 : (now - this.last) / 1000;
    this.last = now;
    const isNeeded = this.work.advance(seconds);
    if (!isNeeded && !this.continuous && this.pending === 0) return this.work.rest();
    const left = (this.pending = Math.max(0, this.pending - 1));
    try {
      this.work.draw();
    } catch (error) {
      this.work.failed(error);
    }
    if (this.pending === left) this.pending = Math.min(left, this.work.frames() - 1);
  };
}
