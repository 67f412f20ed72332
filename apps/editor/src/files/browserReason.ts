/** Why the browser refused to write something, as the end of a sentence, and the mend as a sentence of its own. */
export interface BrowserReason {
  readonly why: string;
  readonly mend: string;
}

/** Letters of a message of the browser's that are shown. */
const LONGEST = 200;

const known: Readonly<Record<string, BrowserReason>> = {
  QuotaExceededError: { why: 'there is no room left', mend: 'Free space on the disk, or choose another place.' },
  NotAllowedError: {
    why: 'the browser may not write there any more',
    mend: 'Allow it when the browser asks, or choose another place.',
  },
  NotFoundError: { why: 'the file or its folder is no longer there', mend: 'Choose another place.' },
  NoModificationAllowedError: {
    why: 'another tab or program holds the file',
    mend: 'Close it there and save again, or choose another place.',
  },
  InvalidStateError: { why: 'the file has changed meanwhile', mend: 'Save again, or choose another place.' },
  NotReadableError: { why: 'the disk cannot be read', mend: 'Choose another place.' },
  // a picker that the user turned back from is no failure and does not come here
  AbortError: { why: 'the browser refused the file', mend: 'Save again under another name.' },
  SecurityError: { why: 'the browser did not allow it', mend: 'Save once more.' },
};

/** The name and message of what was thrown: a DOMException, an Error or anything else. */
export function namedError(error: unknown): { name: string; message: string } {
  if (typeof error !== 'object' || error === null) return { name: 'Error', message: String(error) };
  const { name, message } = error as { name?: unknown; message?: unknown };
  return {
    name: typeof name === 'string' ? name : 'Error',
    message: typeof message === 'string' ? message : '',
  };
}

/** A message of the browser's as the end of a sentence: no capital, no full stop, not too long; never empty. */
export function asClause({ name, message }: { name: string; message: string }): string {
  const text = message.trim().replaceAll(/\s+/g, ' ');
  if (text === '') return `the browser gives no reason but ${name}`;
  const short = text.length > LONGEST ? `${text.slice(0, LONGEST).trimEnd()}…` : text;
  return short.replace(/\.+$/, '').replace(/^[A-Z](?![A-Z])/, (letter) => letter.toLowerCase());
}

/** Why a file was not written. */
export function browserReason(error: unknown): BrowserReason {
  const { name, message } = namedError(error);
  return Object.hasOwn(known, name)
    ? known[name]
    : { why: asClause({ name, message }), mend: 'Save again, or choose another place.' };
}
