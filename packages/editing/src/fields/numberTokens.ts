import { t } from '../language/translate';

/** Error for a text that is no number, with the reason. */
export class NumberSyntaxError extends Error {
  override readonly name = 'NumberSyntaxError';

  /** @param isIncomplete - whether further typing may make the text valid */
  constructor(
    message: string,
    readonly isIncomplete = false,
  ) {
    super(message);
  }
}

/** Token of a number expression. */
export type Token =
  | { readonly kind: 'number'; readonly text: string; readonly value: number }
  | { readonly kind: 'word' | 'sign'; readonly text: string };

const NUMBER = /^(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:e[+-]?\d+)?/i;
const WORD = /^(?:[\p{L}µ]+|[°%"'])/u;
const SIGN = /^(?:\*\*|[-+*/^()²³])/;
/**
 * Splits an expression into tokens.
 * @throws NumberSyntaxError
 */
export function tokensOf(text: string): Token[] {
  const tokens: Token[] = [];
  let rest = text;
  while ((rest = rest.trimStart()) !== '') {
    const [number] = NUMBER.exec(rest) ?? [];
    const found = number ?? (WORD.exec(rest) ?? SIGN.exec(rest))?.[0];
    if (found === undefined) {
      const [character] = rest;
      throw new NumberSyntaxError(t('“{text}” has no place in a number.', { text: character }));
    }
    rest = rest.slice(found.length);
    if (number !== undefined) tokens.push(numberToken(number, rest));
    else tokens.push({ kind: SIGN.test(found) ? 'sign' : 'word', text: found });
  }
  return tokens;
}

/** @param rest - text after the number */
function numberToken(text: string, rest: string): Token {
  if (/^[.,]/.test(rest)) {
    throw new NumberSyntaxError(t('“{text}” has two decimal points.', { text: `${text}${rest}`.split(' ', 1)[0] }));
  }
  if (/^[1-9]\d{0,2},\d{3}$/.test(text)) {
    const [whole, decimals] = text.split(',');
    const values = { text, large: whole + decimals, small: `${whole}.${decimals}` };
    throw new NumberSyntaxError(t('“{text}” may be {large} or {small}: write one of them.', values));
  }
  if (/^e[+-]?$/i.test(rest)) {
    throw new NumberSyntaxError(t('Something is missing after “{text}”.', { text: text + rest }), true);
  }
  return { kind: 'number', text, value: Number(text.replace(',', '.')) };
}
