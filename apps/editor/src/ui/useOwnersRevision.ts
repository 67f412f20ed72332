import type { FieldOwner } from '@farol/engine/fields';
import { useCallback, useSyncExternalStore } from 'react';
import { useEditor } from './EditorContext';

/** Renders again when a field of one of these components changes, or whether it is enabled. @param owners - memoised */
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
