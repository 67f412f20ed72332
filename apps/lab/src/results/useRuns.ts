import { useCallback, useEffect, useState } from 'preact/hooks';
import { messageOf } from '../run/messageOf';
import type { RunInfo, RunStore } from './RunStore';

export interface KeptRuns {
  /** Newest first; null while they are read. */
  readonly runs: readonly RunInfo[] | null;
  /** Reason, a sentence, why they cannot be read. */
  readonly problem: string | null;
}

/** The kept runs, updated by changes in any tab. */
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
