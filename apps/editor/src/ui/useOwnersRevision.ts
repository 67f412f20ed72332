import type { FieldOwner } from '@farol/engine/fields';
import { useMemo, useSyncExternalStore } from 'react';
import { useEditor } from './EditorContext';

/**
 * Renders the calling component when a field of an owner changes, or an owner is switched on or off.
 * @param owners - memoised
 * @param changed - memoised; called with the name of each field that changes, and without a name when any may have
 *   changed
 */
export function useOwnersRevision(owners: readonly FieldOwner[], changed?: (field?: string) => void): number {
  const { document } = useEditor();
  const [subscribe, read] = useMemo(() => {
    const signals = owners.map((owner) => document.ownerSignal(owner));
    const sum = (): number => signals.reduce((all, { revision }) => all + revision, 0);
    // the revision is counted here: summing a thousand signals at each of a thousand emissions would be slow
    let revision = sum();
    let isRead = true;
    const follow = (listener: () => void): (() => void) => {
      if (sum() !== revision) changed?.();
      revision = sum();
      const tell = (field?: string): void => {
        changed?.(field);
        revision++;
        if (isRead) listener();
        isRead = false;
      };
      const endings = signals.map((signal) => signal.subscribe(tell));
      return () => endings.forEach((end) => end());
    };
    return [follow, () => ((isRead = true), revision)] as const;
  }, [document, owners, changed]);
  return useSyncExternalStore(subscribe, read);
}
