import type { WebGLRenderer } from 'three';
import type { Rows } from './FullscreenPass';
import { keepState } from './keepState';
import { CONTEXT_LOST } from './untilLoss';

/** Work drawn in slices: all rows of a target, once for each batch. */
export interface SlicedWork {
  readonly height: number;
  readonly batches: number;
  draw(batch: number, rows: Rows): void;
  /** Called after each slice. @param share - part of the work that is done, 0 to 1 */
  onSlice(share: number, batch: number): void;
}

/** Maximum number of slices queued on the GPU: one runs while the completion of another is handled. */
const IN_FLIGHT = 2;

/** Draws work in slices of about `milliseconds` each, between which the page may draw frames. */
export class Slices {
  constructor(
    private readonly renderer: WebGLRenderer,
    private readonly milliseconds: number,
    private readonly signal: AbortSignal | undefined,
  ) {}

  /** @throws the signal's reason, or an Error when the context is lost */
  async run(work: SlicedWork): Promise<void> {
    const { height, batches, onSlice } = work;
    let perRow = this.milliseconds / 8;
    // rows of all batches, one batch after another
    const all = height * batches;
    const flying: { until: number; rows: number; begin: number; fence: WebGLSync | null }[] = [];
    let given = 0;
    let lastEnd = 0;
    while (given < all || flying.length > 0) {
      this.signal?.throwIfAborted();
      if (given < all && flying.length < IN_FLIGHT) {
        const begin = performance.now();
        const rows = this.drawSlice(work, given, perRow);
        given += rows;
        flying.push({ until: given, rows, begin, fence: this.fence() });
        if (flying.length < IN_FLIGHT && given < all) continue;
      }
      const { until, rows, begin, fence } = flying.shift()!;
      await this.passed(fence);
      const now = performance.now();
      // at most four times as many rows as before, since the next rows may cost more
      perRow = Math.max((now - Math.max(begin, lastEnd)) / rows, perRow / 4);
      lastEnd = now;
      onSlice(until / all, Math.floor(until / height));
    }
  }

  /** @returns number of rows that were drawn */
  private drawSlice({ height, batches, draw }: SlicedWork, from: number, perRow: number): number {
    const begin = performance.now();
    const milliseconds = this.milliseconds / IN_FLIGHT;
    const most = Math.min(Math.max(1, Math.floor(milliseconds / perRow)), height * batches - from);
    let drawn = 0;
    keepState(this.renderer, () => {
      // also ends by the time spent on submitting draws, which with a software renderer is most of the time
      do {
        const first = (from + drawn) % height;
        const count = Math.min(most - drawn, height - first);
        draw(Math.floor((from + drawn) / height), { first, count });
        drawn += count;
      } while (drawn < most && performance.now() - begin < milliseconds);
    });
    return drawn;
  }

  /** Waits until the GPU has finished all work submitted so far. */
  wait(): Promise<void> {
    return this.passed(this.fence());
  }

  private fence(): WebGLSync | null {
    const gl = this.renderer.getContext() as WebGL2RenderingContext;
    const fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    return fence;
  }

  private async passed(fence: WebGLSync | null): Promise<void> {
    const gl = this.renderer.getContext() as WebGL2RenderingContext;
    for (;;) {
      await pause();
      if (fence === null || gl.isContextLost()) throw new Error(CONTEXT_LOST);
      this.signal?.throwIfAborted();
      const state = gl.clientWaitSync(fence, 0, 0);
      // the fence belongs to a context that was lost and restored
      if (state === gl.WAIT_FAILED) throw new Error(CONTEXT_LOST);
      if (state === gl.ALREADY_SIGNALED || state === gl.CONDITION_SATISFIED) break;
    }
    gl.deleteSync(fence);
  }
}

const channel = typeof MessageChannel === 'undefined' ? null : new MessageChannel();

/** Resolves in the next task, by a message, since timers would wait 4 ms. */
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
