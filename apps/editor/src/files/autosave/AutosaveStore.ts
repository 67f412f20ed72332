import { t } from '@farol/editing';
import type { StoredScene, WorkerRequest, WorkerResponse } from './messages';
import type { SessionInfo } from '../../model/SessionInfo';

interface Asked {
  resolve(result: unknown): void;
  reject(error: unknown): void;
}

/**
 * Promise-based interface to the autosave's worker. A worker that dies is restarted with empty memory, see `restarts`.
 */
export class AutosaveStore {
  private worker: Worker | null = null;
  private readonly waiting = new Map<number, Asked>();
  private count = 0;
  private deaths = 0;

  /** Number of times the worker died, losing everything that was sent but not committed. */
  get restarts(): number {
    return this.deaths;
  }

  /** Sends a request. @returns the answer; rejects with the browser's error, reduced to name and message */
  send(request: WorkerRequest): Promise<unknown> {
    const id = ++this.count;
    return new Promise((resolve, reject) => {
      this.worker ??= this.start();
      // oxlint-disable-next-line unicorn/require-post-message-target-origin -- workers have no origin argument
      this.worker.postMessage({ id, request });
      this.waiting.set(id, { resolve, reject });
    });
  }

  /** Unsaved sessions whose tabs are closed, newest first. */
  async lost(): Promise<SessionInfo[]> {
    const sessions = (await this.send({ kind: 'list' })) as SessionInfo[];
    const { held } = await navigator.locks.query();
    const alive = new Set(held?.map(({ name }) => name));
    return sessions.filter(({ id }) => !alive.has(lockOf(id)));
  }

  async read(id: string): Promise<StoredScene> {
    return (await this.send({ kind: 'read', id })) as StoredScene;
  }

  async delete(id: string): Promise<void> {
    await this.send({ kind: 'delete', id });
  }

  dispose(): void {
    this.worker?.terminate();
  }

  private start(): Worker {
    const worker = new Worker(new URL('./autosaveWorker.ts', import.meta.url), { type: 'module' });
    worker.addEventListener('message', ({ data }: MessageEvent<WorkerResponse>) => {
      const asked = this.waiting.get(data.id);
      this.waiting.delete(data.id);
      if (data.error === undefined) asked?.resolve(data.result);
      else asked?.reject(Object.assign(new Error(data.error.message), { name: data.error.name }));
    });
    worker.addEventListener('error', () => {
      worker.terminate();
      this.worker = null;
      this.deaths++;
      const asked = [...this.waiting.values()];
      this.waiting.clear();
      for (const { reject } of asked) reject(new Error(t('The autosave could not be loaded: reload the page.')));
    });
    return worker;
  }
}

/** Name of the lock that a tab holds while it is open. */
export const lockOf = (session: string): string => `farol-autosave-${session}`;
