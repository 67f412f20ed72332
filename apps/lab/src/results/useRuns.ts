import { useCallback, useEffect, useState } from 'preact/hooks';
import { messageOf } from '../run/messageOf';
import type { RunInfo, RunStore } from './RunStore';

/** The kept runs as they are, in this tab and others. */
export interface KeptRuns {
  /** Newest first; null until they are read. */
  readonly runs: readonly RunInfo[] | null;
  /** Why they cannot be read, as a sentence. */
  readonly problem: string | null;
}

export function useRuns(store: RunStore): KeptRuns {
  const [kept, setKept] = useState<KeptRuns>({ runs: null, problem: null });
  const read = useCallback(async () => {
    try {
      setKept({ runs: await store.list(), problem: null });
    } catch (error) {
      setKept({ runs: [], problem: messageOf(error) });
    }
  }, [store]);
  useEffect(() => {
    void read();
    return store.onChange(() => void read());
  }, [store, read]);
  return kept;
}
