import { t } from '@farol/editing';
import { asClause, namedError } from '../browserReason';

const known = (): Readonly<Record<string, string>> => ({
  QuotaExceededError: t('it has no room left for this page; free space on the disk.'),
  SecurityError: t('it does not let this page store data, as in some private windows.'),
  InvalidStateError: t('its storage is closed, as in some private windows.'),
  VersionError: t('its storage is of a newer version of Farol; reload the page.'),
  UnknownError: t('its storage is damaged, or the disk is full.'),
});

/** Why the browser refused to store a draft: a sentence without a capital; never empty. */
export function draftReason(error: unknown): string {
  const named = namedError(error);
  const reasons = known();
  return Object.hasOwn(reasons, named.name) ? reasons[named.name] : `${asClause(named)}.`;
}

/** The missing browser feature without which no draft can be kept, as a sentence without a capital; null for none. */
export function missingForDrafts(): string | null {
  // property access throws on a page with an opaque origin
  const has = (read: () => unknown): boolean => {
    try {
      return read() !== undefined && read() !== null;
    } catch {
      return false;
    }
  };
  if (!has(() => globalThis.indexedDB)) return t('it has no IndexedDB, as in some private windows.');
  if (!has(() => navigator.locks)) return t('it has no Web Locks, which pages have only over https.');
  return null;
}
