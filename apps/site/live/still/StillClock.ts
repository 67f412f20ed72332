/**
 * Clock that stands still, in place of that of the page or worker: frames come when {@link advance} is called, and
 * `performance.now()` is the time of the last one. Same steps, same picture.
 */
export class StillClock {
  /** Time since the page's beginning (s). */
  seconds = 0;
  private callbacks = new Map<number, FrameRequestCallback>();
  private last = 0;
  private readonly nextFrame = globalThis.requestAnimationFrame.bind(globalThis);

  constructor() {
    globalThis.requestAnimationFrame = (callback) => {
      this.callbacks.set(++this.last, callback);
      return this.last;
    };
    globalThis.cancelAnimationFrame = (handle) => void this.callbacks.delete(handle);
    performance.now = () => this.seconds * 1000;
  }

  /** Lets time go by (s) and draws one frame. */
  advance(seconds: number): void {
    this.seconds += seconds;
    const { callbacks } = this;
    this.callbacks = new Map();
    for (const callback of callbacks.values()) callback(this.seconds * 1000);
  }

  /** Draws frames, in which no time goes by, until a promise is fulfilled. */
  async until<T>(promise: Promise<T>): Promise<T> {
    const state = { isPending: true };
    const settle = () => void (state.isPending = false);
    promise.then(settle, settle);
    while (state.isPending) {
      await new Promise((resolve) => this.nextFrame(resolve));
      this.advance(0);
    }
    return promise;
  }
}
