import { openingOf, type ScriptToken, within } from './scriptTokens';

/** A `for (;;)` whose counter changes by a constant in each iteration. Positions are indices of tokens. */
export interface CountedLoop {
  readonly counter: string;
  /** Whether the loop's counter increases. */
  readonly isUp: boolean;
  /** Index of the token of the brace that ends the loop's body. */
  readonly end: number;
}

/** Smallest step of a counter; a smaller one allows too many iterations between two checks of the time limit. */
const LEAST_STEP = 0.01;

/** Tokens allowed in the initial value of a loop's counter; one must be a number, so that the counter is no BigInt. */
const PLAIN = new Set(['name', 'num', '.', '+', '-', '*', '/', '%', '+/-']);

/** Tokens that begin a function, which could capture the counter of an iteration. */
const FUNCTIONS = new Set(['=>', 'function', 'class']);
const BEFORE_BLOCK = new Set(['if', 'for', 'while', 'switch', 'catch', 'with']);

/**
 * Recognises `for (let i = 0; …; i++) { … }` in which only the head assigns to `i` and no function is made; null for
 * any other loop.
 * @param at - index of the token `for`
 * @param close - index of the bracket that closes the head
 */
export function countedLoop(
  code: string,
  tokens: readonly ScriptToken[],
  at: number,
  close: number,
  [first, second]: readonly number[],
): CountedLoop | null {
  const label = (i: number): string => tokens[i]?.label ?? '';
  const text = (i: number): string => code.slice(tokens[i].start, tokens[i].end);
  // a labelled `continue` must not reach the loop that is put around this one
  if (label(at - 1) === ':' || label(close + 1) !== '{') return null;
  if (label(at + 1) !== '(' || label(at + 2) !== 'let' || label(at + 3) !== 'name' || label(at + 4) !== '=')
    return null;
  const counter = text(at + 3);
  let isNumber = false;
  for (let i = at + 5; i < first && label(i) !== ','; i++) {
    if (!PLAIN.has(label(i))) return null;
    isNumber ||= label(i) === 'num';
  }
  const step = isNumber ? stepOf(second + 1, counter, label, text) : null;
  const end = within(tokens, close + 1).close;
  if (!step || end < 0) return null;
  const { length } = step;
  for (let i = at + 5; i < end; i++) {
    const isStep = i > second && i <= second + length;
    if (!isStep && mayChange(tokens, i, counter, label, text)) return null;
  }
  return { counter, isUp: step.isUp, end };
}

/** Recognises `i++`, `++i`, `i += 2` and their decrements, as the whole last part of the head or before a comma. */
function stepOf(
  at: number,
  counter: string,
  label: (i: number) => string,
  text: (i: number) => string,
): { isUp: boolean; length: number } | null {
  const isEnd = (i: number): boolean => label(i) === ')' || label(i) === ',';
  const isCounter = (i: number): boolean => label(i) === 'name' && text(i) === counter;
  if (isCounter(at) && label(at + 1) === '++/--' && isEnd(at + 2)) return { isUp: text(at + 1) === '++', length: 2 };
  if (label(at) === '++/--' && isCounter(at + 1) && isEnd(at + 2)) return { isUp: text(at) === '++', length: 2 };
  if (!isCounter(at) || label(at + 1) !== '_=' || label(at + 2) !== 'num' || !isEnd(at + 3)) return null;
  const sign = text(at + 1);
  if ((sign !== '+=' && sign !== '-=') || !(Number(text(at + 2)) >= LEAST_STEP)) return null;
  return { isUp: sign === '+=', length: 3 };
}

/** Whether a token may begin an assignment to the counter, or a function, which could capture it. */
function mayChange(
  tokens: readonly ScriptToken[],
  i: number,
  counter: string,
  label: (i: number) => string,
  text: (i: number) => string,
): boolean {
  const kind = label(i);
  if (FUNCTIONS.has(kind)) return true;
  if (kind === '{' && label(i - 1) === ')') {
    const open = openingOf(tokens, i - 1);
    // the brace opens the body of a method
    if (!BEFORE_BLOCK.has(label(open - 1)) && !(label(open - 1) === 'name' && text(open - 1) === 'await')) return true;
  }
  if (kind === '=' && (label(i - 1) === ']' || label(i - 1) === '}')) {
    const before = label(openingOf(tokens, i - 1) - 1);
    // a destructuring assignment changes its variables
    if (label(i - 1) === '}' || !(before === 'name' || before === ')' || before === ']')) return true;
  }
  if (kind !== 'name' || text(i) !== counter || label(i - 1) === '.') return false;
  const [before, after] = [label(i - 1), label(i + 1)];
  const isHead = before === '(' && label(i - 2) === 'for';
  return after === '=' || after === '_=' || after === '++/--' || before === '++/--' || isHead;
}
