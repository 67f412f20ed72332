import type { StoredScene, WorkerRequest, WorkerResponse } from './messages';
import type { SessionInfo } from './store';

/** The autosave's worker, asked by promises. */
export class AutosaveStore {
  private readonly worker = new Worker(new URL('./autosaveWorker.ts', import.meta.url), { type: 'module' });
  private readonly waiting = new Map<number, { resolve(result: unknown): void; reject(error: Error): void }>();
  private count = 0;

  constructor() {
    this.worker.addEventListener('message', ({ data }: MessageEvent<WorkerResponse>) => {
      const asked = this.waiting.get(data.id);
      this.waiting.delete(data.id);
      if (data.error === undefined) asked?.resolve(data.result);
      else asked?.reject(new Error(`The autosave: ${data.error}`));
    });
    this.worker.addEventListener('error', () => {
      for (const { reject } of this.waiting.values()) reject(new Error('The autosave does not work in this browser.'));
      this.waiting.clear();
    });
  }

  send(request: WorkerRequest): Promise<unknown> {
    const id = ++this.count;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject });
      // oxlint-disable-next-line unicorn/require-post-message-target-origin -- a worker has none
      this.worker.postMessage({ id, request });
    });
  }

  /** Sessions of other tabs that are there no more, newest first. */
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
    this.worker.terminate();
  }
}

/** Name of the lock that a tab holds for as long as it is there. */
export const lockOf = (session: string): string => `farol-autosave-${session}`;
