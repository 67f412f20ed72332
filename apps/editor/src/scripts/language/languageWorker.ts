import type { LanguageQuestions, ScriptChange, ScriptDeclarations } from './LanguageAnswers';
import { ScriptService } from './ScriptService';

/** Message to the worker: first the URL of the declarations, then queries with the texts changed before. */
export type LanguageRequest =
  | { readonly declarations: string }
  | {
      readonly id: number;
      readonly changes: readonly ScriptChange[];
      readonly question: keyof LanguageQuestions;
      readonly values: readonly unknown[];
    };

/** Answer to a query, or the reason for its failure. */
export type LanguageAnswer =
  | { readonly id: number; readonly answer: unknown }
  | { readonly id: number; readonly error: string };

let service: Promise<ScriptService> | null = null;
/** Queue of queries, which are answered in order. */
let last: Promise<void> = Promise.resolve();

async function makeService(address: string): Promise<ScriptService> {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`${address}: the server answers ${response.status}.`);
  return new ScriptService((await response.json()) as ScriptDeclarations);
}

async function answer(request: Extract<LanguageRequest, { id: number }>): Promise<void> {
  const { id, changes, question, values } = request;
  try {
    const made = await service!;
    made.change(changes);
    const method = made[question] as (...all: unknown[]) => unknown;
    postMessage({ id, answer: method.apply(made, [...values]) } satisfies LanguageAnswer);
  } catch (error) {
    postMessage({ id, error: error instanceof Error ? error.message : String(error) } satisfies LanguageAnswer);
  }
}

addEventListener('message', ({ data }: MessageEvent<LanguageRequest>) => {
  if ('declarations' in data) service = makeService(data.declarations);
  else last = last.then(() => answer(data));
});
