import type { BakeAnswer, BakeQuestion, BakeResults } from './bakeWorker';

/** Maximum number of workers; each has its own copy of xatlas in memory. */
const MOST_WORKERS = 8;

/** Pool of workers that answer requests in parallel, so that the page stays responsive. */
export class WorkerPool {
  private readonly idle: Worker[];
  private readonly waiting: { readonly weight: number; start(worker: Worker): void }[] = [];
  private readonly cancelled: Promise<never>;

  private constructor(
    private readonly workers: readonly Worker[],
    signal: AbortSignal | undefined,
  ) {
    this.idle = [...workers];
    this.cancelled = new Promise<never>((_, reject) => {
      signal?.addEventListener('abort', () => reject(signal.reason), { once: true });
    });
    this.cancelled.catch(() => {});
  }

  /**
   * @param wanted - number of workers, limited by the processors
   * @param signal - aborting rejects open requests with the signal's reason
   */
  static async make(wanted: number, signal: AbortSignal | undefined): Promise<WorkerPool> {
    const { default: BakeWorker } = await import('./bakeWorker?worker&inline');
    signal?.throwIfAborted();
    const cores = Math.max(1, (navigator.hardwareConcurrency ?? 2) - 1);
    return new WorkerPool(
      Array.from({ length: Math.max(1, Math.min(cores, wanted, MOST_WORKERS)) }, () => new BakeWorker()),
      signal,
    );
  }

  /**
   * @param weight - cost: of requests made together, the heaviest is started first
   * @throws Error (as a rejection) with the worker's error message
   */
  ask<Kind extends keyof BakeResults>(
    question: BakeQuestion & { readonly kind: Kind },
    { weight = 0, transfer = [], onProgress }: AskOptions = {},
  ): Promise<BakeResults[Kind]> {
    const answer = new Promise<BakeResults[Kind]>((resolve, reject) => {
      const start = (worker: Worker): void => {
        // aborted to remove the listeners of this request, as the worker gets further requests later
        const answered = new AbortController();
        const { signal } = answered;
        worker.addEventListener(
          'error',
          ({ message }) => reject(new Error(`A worker of the bake failed (${message}): bake again.`)),
          { signal },
        );
        worker.addEventListener(
          'message',
          ({ data }: MessageEvent<BakeAnswer>) => {
            if (data.kind === 'progress') return onProgress?.(data.share);
            answered.abort();
            if (data.kind === 'failed') reject(new Error(data.message));
            else resolve(data.result as BakeResults[Kind]);
            this.idle.push(worker);
            this.startNext();
          },
          { signal },
        );
        worker.postMessage(question, transfer);
      };
      this.waiting.push({ weight, start });
      // requests of one task are sorted before the first begins
      queueMicrotask(() => this.startNext());
    });
    return Promise.race([answer, this.cancelled]);
  }

  /** Ends the workers. */
  dispose(): void {
    for (const worker of this.workers) worker.terminate();
  }

  private startNext(): void {
    this.waiting.sort((a, b) => b.weight - a.weight);
    while (this.idle.length > 0 && this.waiting.length > 0) this.waiting.shift()!.start(this.idle.pop()!);
  }
}

interface AskOptions {
  readonly weight?: number;
  /** Buffers that are transferred to the worker. */
  readonly transfer?: Transferable[];
  onProgress?(share: number): void;
}
