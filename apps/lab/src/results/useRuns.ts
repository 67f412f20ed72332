import { useCallback, useEffect, useState } from 'preact/hooks';
import { messageOf } from '../run/messageOf';
import type { RunInfo, RunStore } from './RunStore';

export interface KeptRuns {
  /** Entries of the kept runs, newest first; null while they are being read. */
  readonly runs: readonly RunInfo[] | null;
  /** Reason, a sentence, why the kept runs cannot be read; null if they can. */
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
