import { useCallback, useEffect, useState } from 'preact/hooks';
import type { LabRun } from '../../results/LabRun';
import { referenceRuns, type ReferenceRun } from '../../results/referenceRuns';
import { messageOf } from '../../run/messageOf';
import { isSoftware } from '../../words/device';

export interface ShownRun {
  /** Null until the reference is fetched, and where there is none. */
  readonly run: LabRun | null;
  /** Whether it lies in the repository. */
  readonly isReference: boolean;
  /** Why the reference cannot be shown, as a sentence. */
  readonly problem: string | null;
  show(run: LabRun): void;
}

/** The run on show: that which was measured or opened last; before any, a reference. */
export function useShownRun(): ShownRun {
  const [run, setRun] = useState<LabRun | null>(null);
  const [problem, setProblem] = useState<string | null>(null);
  useEffect(() => {
    let isOver = false;
    firstReference()
      ?.read()
      .then((reference) => isOver || setRun((now) => now ?? reference))
      .catch((error: unknown) => isOver || setProblem(messageOf(error)));
    return () => void (isOver = true);
  }, []);
  const show = useCallback((next: LabRun) => {
    setRun(next);
    setProblem(null);
  }, []);
  const isReference = run !== null && referenceRuns.some(({ info }) => info.id === run.id);
  return { run, isReference, problem, show };
}

/** That of a graphics card, and Quick, where there is one. */
function firstReference(): ReferenceRun | undefined {
  const rank = (run: ReferenceRun): number =>
    (isSoftware(run.info.device) ? 2 : 0) + (run.info.label === 'Quick' ? 0 : 1);
  return [...referenceRuns].sort((a, b) => rank(a) - rank(b))[0];
}

/** The reference to compare a run with: of the same preset, of a graphics card first; none for a reference itself. */
export function referenceFor(run: LabRun): ReferenceRun | undefined {
  if (referenceRuns.some(({ info }) => info.id === run.id)) return undefined;
  const same = referenceRuns.filter(({ info }) => info.label === run.plan.label);
  return same.find(({ info }) => !isSoftware(info.device)) ?? same[0];
}
