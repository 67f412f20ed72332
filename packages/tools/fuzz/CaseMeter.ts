import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { performance } from 'node:perf_hooks';

const used = (): number => {
  const { heapUsed, arrayBuffers } = process.memoryUsage();
  return heapUsed + arrayBuffers;
};

/** Lets the queue of promises run empty: until then a WeakRef holds what it refers to. */
const turn = (): Promise<void> => new Promise((resolve) => void setImmediate(resolve));

/**
 * Measures what one case costs.
 *
 * Its time is the CPU time of this process, garbage collection included, plus the time that its event loop was idle,
 * waiting for a timer, a stream or a worker: a case that waits counts as slow as one that works. Time in which other
 * processes had the processor is not counted, nor a synchronous wait, which pages do not have. The sum is cut to the
 * wall-clock time, which several threads at work would exceed.
 */
export class CaseMeter {
  /** Time of the longest lap. */
  seconds = 0;
  /** Memory allocated until the end of the first lap (bytes). */
  memory = 0;
  /** Whether garbage of earlier cases was collected meanwhile, so that `memory` is too little by an unknown amount. */
  isBlurred = false;
  private isFirst = true;
  private readonly before = used();
  private start = 0;
  private work = process.cpuUsage();
  private idle = 0;

  private constructor(
    private readonly collect: (() => void) | null,
    /** Cleared by a full garbage collection alone, not by one of young objects, which frees less than `youngBytes`. */
    private readonly canary: WeakRef<object>,
  ) {
    this.restart();
  }

  /**
   * @param collect - collects all garbage, so that memory in use alone is measured; null counts garbage of the case,
   * too
   */
  static async begin(collect: (() => void) | null): Promise<CaseMeter> {
    const canary = new WeakRef({});
    await turn();
    collect?.();
    return new CaseMeter(collect, canary);
  }

  /** Ends a lap; the time of a forced garbage collection is part of no lap. */
  lap(): void {
    const { user, system } = process.cpuUsage(this.work);
    const idle = performance.eventLoopUtilization().idle - this.idle;
    const seconds = Math.min(performance.now() - this.start, (user + system) / 1e3 + idle) / 1e3;
    this.seconds = Math.max(this.seconds, seconds);
    if (this.isFirst) {
      this.isBlurred = this.collect === null && this.canary.deref() === undefined;
      this.collect?.();
      this.memory = used() - this.before;
    }
    this.isFirst = false;
    this.restart();
  }

  private restart(): void {
    this.start = performance.now();
    this.work = process.cpuUsage();
    this.idle = performance.eventLoopUtilization().idle;
  }
}

/** Most bytes of earlier cases' young objects that can be collected during a case without `isBlurred` showing it. */
export const youngBytes = 16 * 2 ** 20;

setFlagsFromString('--expose-gc');

const collect = runInNewContext('gc') as () => void;

/** Collects all garbage, also in a thread that was started without `--expose-gc`. */
export function collectGarbage(): void {
  collect();
  // the memory of array buffers is freed on another thread; a second collection waits for that
  collect();
}
