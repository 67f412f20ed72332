// an optional peer dependency: when it is absent, bundlers fail on named imports, but not on a namespace
import * as sucrase from 'sucrase';

/** A token of JavaScript as sucrase labels it: 'for', '(', 'name', '_=' for `+=`, '++/--'. */
export interface ScriptToken {
  readonly label: string;
  readonly start: number;
  readonly end: number;
}

/** Tokens of a valid JavaScript text. */
export function scriptTokens(code: string): ScriptToken[] {
  const starts = [0];
  for (let at = code.indexOf('\n'); at >= 0; at = code.indexOf('\n', at + 1)) starts.push(at + 1);
  const place = (line: string, column: string): number => starts[Number(line) - 1] + Number(column) - 1;
  return sucrase
    .getFormattedTokens(code, { transforms: [] })
    .split('\n')
    .flatMap((row) => {
      const [, line, column, lastLine, lastColumn, label] = /^(\d+):(\d+)-(\d+):(\d+)\s+(\S+)/.exec(row) ?? [];
      return label ? { label, start: place(line, column), end: place(lastLine, lastColumn) } : [];
    });
}

const OPENING = new Set(['(', '[', '{', '${']);
const CLOSING = new Set([')', ']', '}']);

/** Index of the bracket that closes the one at `open` (-1 for none), and of the semicolons directly inside. */
export function within(tokens: readonly ScriptToken[], open: number): { close: number; semicolons: number[] } {
  const semicolons: number[] = [];
  let depth = 0;
  for (let i = open; i < tokens.length; i++) {
    const { label } = tokens[i];
    if (OPENING.has(label)) depth++;
    else if (CLOSING.has(label) && --depth === 0) return { close: i, semicolons };
    else if (label === ';' && depth === 1) semicolons.push(i);
  }
  return { close: -1, semicolons };
}

/** Index of the bracket that opens the pair closed at `close`; -1 when there is none. */
export function openingOf(tokens: readonly ScriptToken[], close: number): number {
  let depth = 0;
  for (let i = close; i >= 0; i--) {
    if (CLOSING.has(tokens[i].label)) depth++;
    else if (OPENING.has(tokens[i].label) && --depth === 0) return i;
  }
  return -1;
}
