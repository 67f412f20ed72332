import { useCallback, useEffect, useState } from 'preact/hooks';
import type { LabRun } from '../../results/LabRun';
import { referenceRuns, type ReferenceRun } from '../../results/referenceRuns';
import { messageOf } from '../../run/messageOf';
import { isSoftware } from '../../words/device';

export interface ShownRun {
  /** The displayed run; null while a reference is fetched, or without one. */
  readonly run: LabRun | null;
  /** Whether the run is a reference of the repository. */
  readonly isReference: boolean;
  /** Reason, a sentence, why the reference cannot be displayed. */
  readonly problem: string | null;
  show(run: LabRun): void;
}

/** The displayed run: the last one measured or opened, initially a reference. */
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

/** The reference that is displayed first: measured on a graphics card, with the preset Quick, if possible. */
function firstReference(): ReferenceRun | undefined {
  const rank = (run: ReferenceRun): number =>
    (isSoftware(run.info.device) ? 2 : 0) + (run.info.label === 'Quick' ? 0 : 1);
  return [...referenceRuns].sort((a, b) => rank(a) - rank(b))[0];
}

/** The reference to compare a run with: of the same preset, preferably of a graphics card; none for a reference. */
export function referenceFor(run: LabRun): ReferenceRun | undefined {
  if (referenceRuns.some(({ info }) => info.id === run.id)) return undefined;
  const same = referenceRuns.filter(({ info }) => info.label === run.plan.label);
  return same.find(({ info }) => !isSoftware(info.device)) ?? same[0];
}
