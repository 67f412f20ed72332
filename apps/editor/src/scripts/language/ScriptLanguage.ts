import { Signal } from '@farol/editing';
import type { LanguageQuestions, ScriptChange } from './LanguageAnswers';
import type { LanguageAnswer, LanguageRequest } from './languageWorker';

/** How long the worker stays once nobody needs it (ms): it holds about 200 MB. */
const KEPT = 120_000;

interface Waiting {
  resolve(answer: unknown): void;
  reject(error: Error): void;
}

/**
 * TypeScript's language service in a worker, which is fetched and started at the first question. It knows the scripts that
 * `textsOf` gives.
 */
export class ScriptLanguage {
  /** Emits when the worker begins to answer, and when it cannot. */
  readonly changed = new Signal();
  /** Why nothing is answered; null while that is not so. */
  failure: string | null = null;
  /** Whether the first question was answered. */
  isReady = false;

  private worker: Promise<Worker> | null = null;
  private readonly waiting = new Map<number, Waiting>();
  private readonly sent = new Map<string, string>();
  private ids = 0;
  private end: ReturnType<typeof setTimeout> | undefined;

  /** @param textsOf - all scripts as they are being edited, by name */
  constructor(private readonly textsOf: () => ReadonlyMap<string, string>) {}

  /** Somebody needs the worker. @returns a function that says that they no longer do */
  use(): () => void {
    clearTimeout(this.end);
    return () => {
      clearTimeout(this.end);
      this.end = setTimeout(() => void this.stop(), KEPT);
    };
  }

  /** Asks of the scripts as they are now. @throws Error (as a rejection) when the worker cannot be fetched, or fails */
  async ask<Q extends keyof LanguageQuestions>(
    question: Q,
    ...values: Parameters<LanguageQuestions[Q]>
  ): Promise<ReturnType<LanguageQuestions[Q]>> {
    this.worker ??= this.start();
    const worker = await this.worker;
    const id = ++this.ids;
    const changes = this.changes();
    const answered = new Promise<unknown>((resolve, reject) => this.waiting.set(id, { resolve, reject }));
    // oxlint-disable-next-line unicorn/require-post-message-target-origin -- a worker has none
    worker.postMessage({ id, changes, question, values } satisfies LanguageRequest);
    return (await answered) as ReturnType<LanguageQuestions[Q]>;
  }

  /** Ends the worker; the next question starts another one. */
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
      // oxlint-disable-next-line unicorn/require-post-message-target-origin -- a worker has none
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

  /** The texts that the worker does not have yet. */
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
