import { asClause, namedError } from '../browserReason';

const known: Readonly<Record<string, string>> = {
  QuotaExceededError: 'it has no room left for this page; free space on the disk.',
  SecurityError: 'it lets this page store nothing, as in some private windows.',
  InvalidStateError: 'its store is shut, as in some private windows.',
  VersionError: 'its store is that of a newer version of Farol; reload the page.',
  UnknownError: 'its store is damaged, or the disk is full.',
};

/** Why the browser refused to store a draft: a sentence without a capital, never empty. */
export function draftReason(error: unknown): string {
  const named = namedError(error);
  return Object.hasOwn(known, named.name) ? known[named.name] : `${asClause(named)}.`;
}

/** What the browser lacks without which no draft can be kept, in the same form; null for nothing. */
export function missingForDrafts(): string | null {
  // a page of no origin of its own may not even ask
  const has = (read: () => unknown): boolean => {
    try {
      return read() !== undefined && read() !== null;
    } catch {
      return false;
    }
  };
  if (!has(() => globalThis.indexedDB)) return 'it has no IndexedDB, as in some private windows.';
  if (!has(() => navigator.locks)) return 'it has no Web Locks, which pages have only over https.';
  return null;
}
