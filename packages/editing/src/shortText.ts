/**
 * Matches controls, format and direction marks, private use, replacement characters, lone surrogates, ends of lines.
 */
const UNPRINTABLE = /[\p{C}\p{Zl}\p{Zp}\ufffd]/gu;

const escapeOf = (letter: string): string => `\\u{${letter.codePointAt(0)!.toString(16)}}`;

/**
 * Text of a user's for a message: at most `most` letters, '…' where more were cut off, and what cannot be seen written
 * as \u{7}. Whatever comes from a file goes through this before it is a part of an error.
 */
export function shortText(text: string, most = 40): string {
  const cut = text.length > most ? `${text.slice(0, most - 1)}…` : text;
  return cut.replace(UNPRINTABLE, escapeOf);
}
