/**
 * Matches controls, format and direction marks, private use, replacement characters, lone surrogates, ends of lines.
 */
const UNPRINTABLE = /[\p{C}\p{Zl}\p{Zp}\ufffd]/gu;

const escapeOf = (letter: string): string => `\\u{${letter.codePointAt(0)!.toString(16)}}`;

/**
 * Shortens a user's text for a message to `most` characters and '…'; invisible characters are escaped as in \u{7}. Use
 * it for all text from files in errors.
 */
export function shortText(text: string, most = 40): string {
  const cut = text.length > most ? `${text.slice(0, most - 1)}…` : text;
  return cut.replace(UNPRINTABLE, escapeOf);
}
