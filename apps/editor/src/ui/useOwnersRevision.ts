import type { FieldOwner } from '@farol/engine/fields';
import { useMemo, useSyncExternalStore } from 'react';
import { useEditor } from './EditorContext';

/** Renders again when a field of a component changes, or when it is switched on or off. @param owners - memoised */
export function useOwnersRevision(owners: readonly FieldOwner[]): number {
  const { document } = useEditor();
  const [subscribe, read] = useMemo(() => {
    const signals = owners.map((owner) => document.ownerSignal(owner));
    const sum = (): number => signals.reduce((all, { revision }) => all + revision, 0);
    // kept as a number: an edit of a thousand owners tells a thousand times
    let revision = sum();
    let isRead = true;
    const follow = (listener: () => void): (() => void) => {
      revision = sum();
      const tell = (): void => {
        revision++;
        if (isRead) listener();
        isRead = false;
      };
      const endings = signals.map((signal) => signal.subscribe(tell));
      return () => endings.forEach((end) => end());
    };
    return [follow, () => ((isRead = true), revision)] as const;
  }, [document, owners]);
  return useSyncExternalStore(subscribe, read);
}
