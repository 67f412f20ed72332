import type { FieldOwner } from '@farol/engine/fields';
import { useCallback, useSyncExternalStore } from 'react';
import { useEditor } from './EditorContext';

/** Renders again when a field of a component changes, or when it is switched on or off. @param owners - memoised */
export function useOwnersRevision(owners: readonly FieldOwner[]): number {
  const { document } = useEditor();
  const subscribe = useCallback(
    (listener: () => void) => {
      const endings = owners.map((owner) => document.ownerSignal(owner).subscribe(listener));
      return () => endings.forEach((end) => end());
    },
    [document, owners],
  );
  return useSyncExternalStore(subscribe, () =>
    owners.reduce((sum, owner) => sum + document.ownerSignal(owner).revision, 0),
  );
}
