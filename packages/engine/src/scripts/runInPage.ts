import type { CompiledScript, ScriptFunction } from './CompiledScript';
import { ScriptError } from './ScriptError';

/** Global table in which compiled scripts store their functions, by name. */
export const givenScripts = (): Record<string, ScriptFunction | undefined> =>
  ((globalThis as { farolScripts?: Record<string, ScriptFunction> }).farolScripts ??= {});

/** Removes and returns the function that a script stored under a name. @throws ScriptError when there is none */
export function takeGiven(name: string): ScriptFunction {
  const given = givenScripts();
  const taken = given[name];
  delete given[name];
  if (!taken)
    throw new ScriptError(name, 'it did not run: the page may not run scripts. Look at its Content-Security-Policy.');
  return taken;
}

/**
 * Runs a compiled script as a script of the page; the page's Content-Security-Policy must allow `blob:` scripts.
 * @throws ScriptError for invalid JavaScript
 */
export function runInPage({ name, code }: CompiledScript): Promise<ScriptFunction> {
  const url = URL.createObjectURL(new Blob([code], { type: 'text/javascript' }));
  const element = document.createElement('script');
  return new Promise<ScriptFunction>((resolve, reject) => {
    let problem: ScriptError | null = null;
    const noteError = (event: ErrorEvent): void => {
      if (!event.filename.includes('farol-scripts/') && event.filename !== url) return;
      event.preventDefault();
      event.stopImmediatePropagation();
      problem = new ScriptError(name, event.message.replace(/^Uncaught /, ''), event.lineno, event.colno);
    };
    addEventListener('error', noteError, true);
    const end = (settle: () => void): void => {
      removeEventListener('error', noteError, true);
      element.remove();
      URL.revokeObjectURL(url);
      settle();
    };
    element.addEventListener('load', () =>
      end(() => {
        try {
          if (problem) throw problem;
          resolve(takeGiven(name));
        } catch (error) {
          reject(error as Error);
        }
      }),
    );
    element.addEventListener('error', () =>
      end(() =>
        reject(
          new ScriptError(name, 'the page may not run it: its Content-Security-Policy must allow scripts of blob:.'),
        ),
      ),
    );
    element.src = url;
    document.head.append(element);
  });
}
