import { getFormattedTokens } from 'sucrase';

/** Passes of a script's loops between two looks at the clock; a power of two. */
const PASSES = 256;

/** What every pass of a loop does: it counts, and now and then asks whether it has gone on for too long. */
const GUARD = `(++$passes&${PASSES - 1}||$check())`;

interface Token {
  readonly label: string;
  readonly start: number;
  readonly end: number;
}

function tokensOf(code: string): Token[] {
  const starts = [0];
  for (let at = code.indexOf('\n'); at >= 0; at = code.indexOf('\n', at + 1)) starts.push(at + 1);
  const place = (line: string, column: string): number => starts[Number(line) - 1] + Number(column) - 1;
  return getFormattedTokens(code, { transforms: [] })
    .split('\n')
    .flatMap((row) => {
      const [, line, column, lastLine, lastColumn, label] = /^(\d+):(\d+)-(\d+):(\d+)\s+(\S+)/.exec(row) ?? [];
      return label ? { label, start: place(line, column), end: place(lastLine, lastColumn) } : [];
    });
}

const OPENING = new Set(['(', '[', '{', '${']);
const CLOSING = new Set([')', ']', '}']);

/** The place of the bracket that closes the one at `open`, and those of the semicolons directly within. */
function within(tokens: readonly Token[], open: number): { close: number; semicolons: number[] } {
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

/**
 * JavaScript whose loops look at the clock now and then, on the same lines: `for (;;)`, `while`, `do`, and `for … of` and
 * `for … in` with braces. It needs `$passes`, a number, and `$check`, a function that throws when they go on for too long.
 */
export function guardLoops(code: string): string {
  if (!/\b(for|while)\b/.test(code)) return code;
  const tokens = tokensOf(code);
  /** What is put in, by where. */
  const additions: [at: number, text: string][] = [];
  tokens.forEach(({ label }, i) => {
    if (label === 'while' && tokens[i + 1]?.label === '(') additions.push([tokens[i + 1].end, `${GUARD},`]);
    if (label !== 'for') return;
    const open = tokens.findIndex((token, at) => at > i && token.label === '(');
    const { close, semicolons } = within(tokens, open);
    if (close < 0) return;
    const [first, second] = semicolons;
    if (second !== undefined)
      additions.push([tokens[first].end, second === first + 1 ? `(${GUARD},true)` : `${GUARD},`]);
    else if (tokens[close + 1]?.label === '{') additions.push([tokens[close + 1].end, `${GUARD};`]);
  });
  let text = '';
  let last = 0;
  for (const [at, added] of additions.toSorted((a, b) => a[0] - b[0])) {
    text += code.slice(last, at) + added;
    last = at;
  }
  return text + code.slice(last);
}
