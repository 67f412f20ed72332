// Controls, line and paragraph separators, marks that turn the direction of text, what is not seen, and halves of pairs.
const UNPRINTABLE =
  // oxlint-disable-next-line no-control-regex -- these are what must not come into a message
  /[\u0000-\u001f\u007f-\u009f\u00ad\u061c\u200b-\u200f\u2028-\u202e\u2060-\u206f\ufeff\ufff0-\uffff]|[\ud800-\udbff](?![\udc00-\udfff])|(?<![\ud800-\udbff])[\udc00-\udfff]/g;

const escapeOf = (letter: string): string => `\\u${letter.charCodeAt(0).toString(16).padStart(4, '0')}`;

/**
 * Text of a user's for a message: at most `most` letters, '…' where more were cut off, and what cannot be seen written
 * as \u0007. Whatever comes from a file goes through this before it is a part of an error.
 */
export function shortText(text: string, most = 40): string {
  const cut = text.length > most ? `${text.slice(0, most - 1)}…` : text;
  return cut.replace(UNPRINTABLE, escapeOf);
}
