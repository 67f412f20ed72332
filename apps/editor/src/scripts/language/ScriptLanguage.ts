import { Signal } from '@farol/editing';
import type { LanguageQuestions, ScriptChange } from './LanguageAnswers';
import type { LanguageAnswer, LanguageRequest } from './languageWorker';

/** Time that an unused worker keeps running (ms); it takes about 200 MB. */
const KEPT = 120_000;

interface Waiting {
  resolve(answer: unknown): void;
  reject(error: Error): void;
}

/** TypeScript's language service in a worker, which is started at the first query. */
export class ScriptLanguage {
  /** Emits when the worker is ready, and when it fails. */
  readonly changed = new Signal();
  /** Why the service is unavailable; null when it is available. */
  failure: string | null = null;
  /** Whether the language service has answered its first query. */
  isReady = false;

  private worker: Promise<Worker> | null = null;
  private readonly waiting = new Map<number, Waiting>();
  private readonly sent = new Map<string, string>();
  private ids = 0;
  private end: ReturnType<typeof setTimeout> | undefined;

  /** @param textsOf - returns the texts of all scripts as edited, by name */
  constructor(private readonly textsOf: () => ReadonlyMap<string, string>) {}

  /** Keeps the worker running. @returns a function that releases it */
  use(): () => void {
    clearTimeout(this.end);
    return () => {
      clearTimeout(this.end);
      this.end = setTimeout(() => void this.stop(), KEPT);
    };
  }

  /** Queries the service about scripts. @throws Error (as a rejection) when the worker cannot be fetched, or fails */
  async ask<Q extends keyof LanguageQuestions>(
    question: Q,
    ...values: Parameters<LanguageQuestions[Q]>
  ): Promise<ReturnType<LanguageQuestions[Q]>> {
    this.worker ??= this.start();
    const worker = await this.worker;
    const id = ++this.ids;
    const changes = this.changes();
    const answered = new Promise<unknown>((resolve, reject) => this.waiting.set(id, { resolve, reject }));
    // oxlint-disable-next-line unicorn/require-post-message-target-origin -- workers have no origin argument
    worker.postMessage({ id, changes, question, values } satisfies LanguageRequest);
    return (await answered) as ReturnType<LanguageQuestions[Q]>;
  }

  /** Stops the worker; the next query starts another one. */
  private async stop(): Promise<void> {
    const worker = this.worker;
    this.forget(new Error('The panel was closed.'));
    (await worker?.catch(() => null))?.terminate();
  }

  private async start(): Promise<Worker> {
    try {
      const { default: address } = await import('virtual:script-declarations');
      const worker = new Worker(new URL('./languageWorker.ts', import.meta.url), { type: 'module' });
      worker.addEventListener('message', ({ data }: MessageEvent<LanguageAnswer>) => this.answered(data));
      worker.addEventListener('error', ({ message }) => this.failed(new Error(message)));
      // oxlint-disable-next-line unicorn/require-post-message-target-origin -- workers have no origin argument
      worker.postMessage({ declarations: new URL(address, location.href).href } satisfies LanguageRequest);
      return worker;
    } catch (error) {
      this.failed(error as Error);
      throw error;
    }
  }

  private answered(data: LanguageAnswer): void {
    const waiting = this.waiting.get(data.id);
    this.waiting.delete(data.id);
    if ('error' in data) waiting?.reject(new Error(data.error));
    else waiting?.resolve(data.answer);
    if (this.isReady) return;
    this.isReady = !('error' in data);
    this.failure = 'error' in data ? data.error : null;
    this.changed.emit();
  }

  private failed(error: Error): void {
    this.failure = error.message;
    this.forget(error);
    this.changed.emit();
  }

  private forget(error: Error): void {
    this.worker = null;
    this.isReady = false;
    this.sent.clear();
    const waiting = [...this.waiting.values()];
    this.waiting.clear();
    for (const { reject } of waiting) reject(error);
  }

  /** The texts that changed since the last message to the worker. */
  private changes(): ScriptChange[] {
    const texts = this.textsOf();
    const changes: ScriptChange[] = [];
    for (const [name, text] of texts) {
      if (this.sent.get(name) === text) continue;
      this.sent.set(name, text);
      changes.push([name, text]);
    }
    for (const name of this.sent.keys()) {
      if (texts.has(name)) continue;
      this.sent.delete(name);
      changes.push([name, null]);
    }
    return changes;
  }
}
