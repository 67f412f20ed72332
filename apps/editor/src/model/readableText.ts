// Characters removed from messages: control characters except tab and line ends, marks of text direction, invisible
// characters, lone surrogates, and the replacement character of undecodable bytes.
const UNREADABLE =
  // oxlint-disable-next-line no-control-regex -- control characters are to be matched
  /(?:[\u0000-\u0008\u000b-\u001f\u007f-\u009f\u00ad\u061c\u200b-\u200f\u2028-\u202e\u2060-\u206f\ufeff\ufff0-\uffff]|[\ud800-\udbff](?![\udc00-\udfff])|(?<![\ud800-\udbff])[\udc00-\udfff]|\\u(?:00[01]|fff)[0-9a-f]|\\u\{(?:1?[0-9a-f]|fff[0-9a-f])\})+/gi;

/** Longest message shown (characters); Farol's own messages are shorter. */
const MOST = 2000;

/** A message with each run of unreadable characters, as of a binary file, replaced by '…', cut off after 2,000. */
export const readableText = (text: string): string =>
  `${text.slice(0, MOST)}${text.length > MOST ? '…' : ''}`.replace(UNREADABLE, '…');
