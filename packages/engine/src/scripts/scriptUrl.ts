import type { ScriptPlace } from './ScriptError';

const FOLDER = 'farol-scripts/';

/** Whether the text of a script of this name is TypeScript. */
export const isTypeScript = (name: string): boolean => !/\.m?js$/.test(name);

/** URL of a script in stack traces: `farol-scripts/` and its name. */
export function scriptUrl(name: string): string {
  const file = /\.(m?js|ts)$/.test(name) ? name : `${name}.ts`;
  // escapes characters that would end the URL in a stack trace
  return FOLDER + encodeURIComponent(file).replaceAll('(', '%28').replaceAll(')', '%29').replaceAll('%2F', '/');
}

/**
 * Innermost script position in an error's stack; null when no frame is in a script.
 * @param names - names of all scripts
 */
export function placeOfError(error: unknown, names: Iterable<string>): ScriptPlace | null {
  const stack = error instanceof Error ? (error.stack ?? '') : '';
  const [, path, line, column] = /farol-scripts\/([^\s:()]+):(\d+):(\d+)/.exec(stack) ?? [];
  if (path === undefined) return null;
  for (const script of names) {
    if (scriptUrl(script) === FOLDER + path) return { script, line: Number(line), column: Number(column) };
  }
  return { script: decodeURIComponent(path), line: Number(line), column: Number(column) };
}
