import { t } from '@farol/editing';

/** Why the browser refused to write a file, as the end of a sentence; and the remedy, as another sentence. */
export interface BrowserReason {
  readonly why: string;
  readonly mend: string;
}

/** Longest message of a browser that is shown (characters). */
const LONGEST = 200;

const known = (): Readonly<Record<string, BrowserReason>> => ({
  QuotaExceededError: { why: t('there is no room left'), mend: t('Free space on the disk, or choose another place.') },
  NotAllowedError: {
    why: t('the browser may not write there any more'),
    mend: t('Allow it when the browser asks, or choose another place.'),
  },
  NotFoundError: { why: t('the file or its folder is no longer there'), mend: t('Choose another place.') },
  NoModificationAllowedError: {
    why: t('another tab or program holds the file'),
    mend: t('Close it there and save again, or choose another place.'),
  },
  InvalidStateError: { why: t('the file has changed meanwhile'), mend: t('Save again, or choose another place.') },
  NotReadableError: { why: t('the disk cannot be read'), mend: t('Choose another place.') },
  // the user's cancellation of a picker is no failure, and is handled elsewhere
  AbortError: { why: t('the browser refused the file'), mend: t('Save again under another name.') },
  SecurityError: { why: t('the browser did not allow it'), mend: t('Save once more.') },
});

/** Name and message of anything thrown: a DOMException, an Error or another value. */
export function namedError(error: unknown): { name: string; message: string } {
  if (typeof error !== 'object' || error === null) return { name: 'Error', message: String(error) };
  const { name, message } = error as { name?: unknown; message?: unknown };
  return {
    name: typeof name === 'string' ? name : 'Error',
    message: typeof message === 'string' ? message : '',
  };
}

/** A browser's message as the end of a sentence: no capital, no full stop, shortened; never empty. */
export function asClause({ name, message }: { name: string; message: string }): string {
  const text = message.trim().replaceAll(/\s+/g, ' ');
  if (text === '') return t('the browser gives no reason but {name}', { name });
  const short = text.length > LONGEST ? `${text.slice(0, LONGEST).trimEnd()}…` : text;
  return short.replace(/\.+$/, '').replace(/^[A-Z](?![A-Z])/, (letter) => letter.toLowerCase());
}

/** Turns an error of writing a file into a reason for the user. */
export function browserReason(error: unknown): BrowserReason {
  const { name, message } = namedError(error);
  const reasons = known();
  return Object.hasOwn(reasons, name)
    ? reasons[name]
    : { why: asClause({ name, message }), mend: t('Save again, or choose another place.') };
}
