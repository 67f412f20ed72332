import { countedLoop } from './countedLoop';
import { scriptTokens, within } from './scriptTokens';

/** Iterations of a script's loops between two checks of the time limit; a power of two. */
const PASSES = 256;

/** Increase of a `for` loop's counter between two checks of the time limit, where such a counter is found. */
const STEPS = 1024;

/** Expression inserted into loops: counts iterations, and checks the time limit every `PASSES` of them. */
const GUARD = `(($passes=$passes+1&${PASSES - 1})||$check())`;

/**
 * Adds checks of a time limit to the loops of JavaScript (`for` of every kind, `while` and `do`); line numbers are
 * kept. The result needs `$passes`, a number, and `$check`, a function that throws when a loop runs for too long.
 *
 * A call inside a loop prevents its optimisation by browsers, even if it is not executed. A counting `for` is therefore
 * wrapped in an outer loop, which makes the call each time the counter has advanced by `STEPS`: `for(let
 * i=0,$end=…;;){for($end=i+1024;!(i>=$end)&&(i<n);i++){…}if(!(i>=$end))break;$check();}`.
 */
export function guardLoops(code: string): string {
  if (!/\b(for|while)\b/.test(code)) return code;
  const tokens = scriptTokens(code);
  /** Texts to insert, each with its offset in the code. */
  const additions: [at: number, text: string][] = [];
  tokens.forEach(({ label }, i) => {
    if (label === 'while' && tokens[i + 1]?.label === '(') additions.push([tokens[i + 1].end, `${GUARD},`]);
    if (label !== 'for') return;
    const open = tokens.findIndex((token, at) => at > i && token.label === '(');
    const { close, semicolons } = within(tokens, open);
    if (close < 0) return;
    const [first, second] = semicolons;
    if (second === undefined) {
      const hasBraces = tokens[close + 1]?.label === '{';
      // the inner `if` gets its own `else`, so that an `else` after the loop still belongs to the outer `if`
      additions.push(
        hasBraces ? [tokens[close + 1].end, `${GUARD};`] : [tokens[close].end, `if(${GUARD},false);else `],
      );
      return;
    }
    const isEmpty = second === first + 1;
    const counted = countedLoop(code, tokens, i, close, semicolons);
    if (!counted) {
      additions.push([tokens[first].end, isEmpty ? `(${GUARD},true)` : `${GUARD},`]);
      return;
    }
    const { counter, isUp, end } = counted;
    const goesOn = isUp ? `!(${counter}>=$end)` : `!(${counter}<=$end)`;
    additions.push(
      [tokens[first].start, `,$end=${GUARD};;){for($end=${counter}${isUp ? '+' : '-'}${STEPS}`],
      [tokens[first].end, isEmpty ? goesOn : `${goesOn}&&(`],
      ...(isEmpty ? [] : [[tokens[second].start, ')'] as [number, string]]),
      [tokens[end].end, `if(${goesOn})break;$check();}`],
    );
  });
  let text = '';
  let last = 0;
  for (const [at, added] of additions.toSorted((a, b) => a[0] - b[0])) {
    text += code.slice(last, at) + added;
    last = at;
  }
  return text + code.slice(last);
}
