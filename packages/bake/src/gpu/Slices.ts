import type { WebGLRenderer } from 'three';
import type { Rows } from './FullscreenPass';
import { keepState } from './keepState';

/** What is drawn in slices: all rows of a target, once for each batch. */
export interface SlicedWork {
  readonly height: number;
  readonly batches: number;
  draw(batch: number, rows: Rows): void;
  /** After each slice, with the share of the work that is done. */
  onSlice(share: number, batch: number): void;
}

/** Draws work in slices of about so many milliseconds of GPU time, between which the page may draw. */
export class Slices {
  private lastFrame = performance.now();

  constructor(
    private readonly renderer: WebGLRenderer,
    private readonly milliseconds: number,
    private readonly signal: AbortSignal | undefined,
  ) {}

  /** @throws the signal's reason, or an Error when the context is lost */
  async run(work: SlicedWork): Promise<void> {
    const { height, batches, onSlice } = work;
    let perRow = this.milliseconds / 8;
    // rows of all batches, one after the other
    const all = height * batches;
    let done = 0;
    while (done < all) {
      this.signal?.throwIfAborted();
      const begin = performance.now();
      const drawn = this.drawSlice(work, done, perRow);
      await this.wait();
      // not more than four times as much at once: the next rows may be dearer
      perRow = Math.max((performance.now() - begin) / drawn, perRow / 4);
      done += drawn;
      onSlice(done / all, Math.floor(done / height));
      await this.nextFrame();
    }
  }

  /** @returns rows that were drawn */
  private drawSlice({ height, batches, draw }: SlicedWork, from: number, perRow: number): number {
    const begin = performance.now();
    const most = Math.min(Math.max(1, Math.floor(this.milliseconds / perRow)), height * batches - from);
    let drawn = 0;
    keepState(this.renderer, () => {
      // submitting takes time as well, where the GPU is a processor's
      do {
        const first = (from + drawn) % height;
        const count = Math.min(most - drawn, height - first);
        draw(Math.floor((from + drawn) / height), { first, count });
        drawn += count;
      } while (drawn < most && performance.now() - begin < this.milliseconds);
    });
    return drawn;
  }

  /** Waits until the GPU has done what it was given. */
  async wait(): Promise<void> {
    const gl = this.renderer.getContext() as WebGL2RenderingContext;
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    for (;;) {
      await pause();
      if (fence === null || gl.isContextLost()) throw new Error('The bake ended: the WebGL context was lost.');
      const state = gl.clientWaitSync(fence, 0, 0);
      if (state === gl.ALREADY_SIGNALED || state === gl.CONDITION_SATISFIED) break;
    }
    gl.deleteSync(fence);
    this.signal?.throwIfAborted();
  }

  /** Lets the page draw, if it did not for a while. A page that is not seen draws nothing. */
  private async nextFrame(): Promise<void> {
    if (performance.now() - this.lastFrame < 12) return;
    await new Promise<void>((resolve) => {
      const timer = setTimeout(resolve, 50);
      requestAnimationFrame(() => {
        clearTimeout(timer);
        resolve();
      });
    });
    this.lastFrame = performance.now();
  }
}

const channel = typeof MessageChannel === 'undefined' ? null : new MessageChannel();

/** Until the next task: timers would wait four milliseconds. */
function pause(): Promise<void> {
  return new Promise((resolve) => {
    if (!channel) setTimeout(resolve);
    else {
      channel.port1.addEventListener('message', () => resolve(), { once: true });
      channel.port1.start();
      channel.port2.postMessage(null);
    }
  });
}
