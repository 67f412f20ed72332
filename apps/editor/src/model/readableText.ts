// Controls but line ends and tabs, marks that turn the direction of text, what is not seen, halves of pairs, and the sign
// that stands for bytes that are no text.
const UNREADABLE =
  // oxlint-disable-next-line no-control-regex -- these are what must not come into a message
  /(?:[\u0000-\u0008\u000b-\u001f\u007f-\u009f\u00ad\u061c\u200b-\u200f\u2028-\u202e\u2060-\u206f\ufeff\ufff0-\uffff]|[\ud800-\udbff](?![\udc00-\udfff])|(?<![\ud800-\udbff])[\udc00-\udfff]|\\u(?:00[01]|fff)[0-9a-f]|\\u\{(?:1?[0-9a-f]|fff[0-9a-f])\})+/gi;

/** Letters of a message that are shown: more than any that Farol writes has. */
const MOST = 2000;

/**
 * A message without broken bytes, such as those of a name or of a file that is no text: '…' stands for each run of them, and
 * for what is beyond 2,000 letters.
 */
export const readableText = (text: string): string =>
  `${text.slice(0, MOST)}${text.length > MOST ? '…' : ''}`.replace(UNREADABLE, '…');
