import { useCallback, useEffect, useRef, useState } from 'preact/hooks';
import type { LabCase, LabPlan, LabSeries } from '../../plan/LabPlan';
import { LAB_RUN_VERSION, type LabRun, type LabSurroundings } from '../../results/LabRun';
import type { Progress } from '../../run/Progress';
import { runPlan } from '../../run/runPlan';
import type { StageFrames } from '../../run/StageFrames';
import { holdPicture } from './sharpPictures';
import { messageOf } from '../../run/messageOf';

/** Interval between updates of the progress (ms). */
const WORDS = 200;

export interface Running {
  readonly plan: LabPlan;
  readonly done: number;
  readonly total: number;
  /** Time left (ms); null while unknown. */
  readonly remaining: number | null;
  readonly competitor: string | null;
  readonly series: LabSeries;
  readonly labCase: LabCase;
  /** The picture that a competitor drew last; null before the first picture. */
  readonly picture: ImageData | null;
  readonly isCancelled: boolean;
  /** The finished cases, as a run. */
  readonly run: LabRun;
}

export interface RunState {
  readonly running: Running | null;
  /** Whether a run was started whose first step has not begun. */
  readonly isStarting: boolean;
  /** Reason, a sentence, why the last run failed; null if it did not. */
  readonly problem: string | null;
  /**
   * Measures a plan.
   *
   * @param prepare - creates the iframes and reads the surroundings
   * @returns the run, complete or cancelled; null if it failed
   */
  start(plan: LabPlan, prepare: () => Promise<Prepared>): Promise<LabRun | null>;
  /** Cancels the run after the current turn; its rows are kept. */
  cancel(): void;
}

export interface Prepared {
  readonly frames: StageFrames;
  readonly surroundings: LabSurroundings;
  readonly mostContexts: number;
}

/** Starts runs, and returns the progress of the current one. */
export function useRun(): RunState {
  const [running, setRunning] = useState<Running | null>(null);
  const [isStarting, setStarting] = useState(false);
  const [problem, setProblem] = useState<string | null>(null);
  const abort = useRef<AbortController | null>(null);
  useEffect(() => () => abort.current?.abort(), []);
  const isRunning = running !== null;
  useEffect(() => {
    if (!isRunning) return;
    // makes the browser ask the user, since closing the tab would lose the rows
    const ask = (event: BeforeUnloadEvent): void => event.preventDefault();
    addEventListener('beforeunload', ask);
    return () => removeEventListener('beforeunload', ask);
  }, [isRunning]);

  const start = useCallback(async (plan: LabPlan, prepare: () => Promise<Prepared>): Promise<LabRun | null> => {
    if (abort.current) return null;
    const controller = new AbortController();
    abort.current = controller;
    setProblem(null);
    setStarting(true);
    try {
      const { frames, surroundings, mostContexts } = await prepare();
      const begin = performance.now();
      let words = -Infinity;
      let run = partial(plan, surroundings, null, 0);
      let last: ImageData | null = null;
      const onProgress = (progress: Progress): void => {
        const { series, labCase, competitor, picture } = progress;
        if (picture !== last && picture && competitor !== null) {
          holdPicture(plan, { series: series.name, index: series.cases.indexOf(labCase), competitor }, picture);
        }
        last = picture;
        const now = performance.now();
        if (now - words < WORDS) return;
        words = now;
        setStarting(false);
        show(progress);
      };
      const show = ({ done, total, remaining, competitor, series, labCase, picture }: Progress): void => {
        const isCancelled = controller.signal.aborted;
        setRunning({ plan, done, total, remaining, competitor, series, labCase, picture, isCancelled, run });
      };
      const onCase = async (progress: Progress): Promise<void> => {
        run = partial(plan, surroundings, progress, performance.now() - begin);
        show(progress);
        await drawn();
      };
      const { signal } = controller;
      return await runPlan(plan, { frames, surroundings, mostContexts, onProgress, onCase, signal });
    } catch (error) {
      setProblem(messageOf(error));
      return null;
    } finally {
      abort.current = null;
      setRunning(null);
      setStarting(false);
    }
  }, []);

  const cancel = useCallback(() => {
    abort.current?.abort();
    setRunning((now) => now && { ...now, isCancelled: true });
  }, []);
  return { running, isStarting, problem, start, cancel };
}

/** Waits until the page has drawn its changes, at most 250 ms, since a hidden page does not draw. */
function drawn(): Promise<void> {
  return new Promise((resolve) => {
    setTimeout(resolve, 250);
    requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(resolve)));
  });
}

/** Copy of the rows so far as a run, which is not changed by later turns. */
function partial(plan: LabPlan, surroundings: LabSurroundings, progress: Progress | null, duration: number): LabRun {
  return {
    format: 'farol-lab-run',
    version: LAB_RUN_VERSION,
    ...{ id: 'running', name: '', surroundings, plan, complete: false, duration },
    rows: progress ? progress.rows.map((row) => ({ ...row })) : [],
  };
}
