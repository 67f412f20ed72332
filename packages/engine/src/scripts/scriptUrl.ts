import type { ScriptPlace } from './ScriptError';

const FOLDER = 'farol-scripts/';

/** Whether the text of a script of this name is TypeScript. */
export const isTypeScript = (name: string): boolean => !/\.m?js$/.test(name);

/** The address that stack traces name for a script: `farol-scripts/` and its name. */
export function scriptUrl(name: string): string {
  const file = /\.(m?js|ts)$/.test(name) ? name : `${name}.ts`;
  // characters that would end the address within a stack trace
  return FOLDER + encodeURIComponent(file).replaceAll('(', '%28').replaceAll(')', '%29').replaceAll('%2F', '/');
}

/**
 * The innermost place in a script that an error came from; null where none of its stack is in a script.
 * @param names - of the scripts that there are
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
