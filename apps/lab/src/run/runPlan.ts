import { MOST_CONTEXTS } from '../plan/planOf';
import type { LabCase, LabPlan, LabSeries } from '../plan/LabPlan';
import { LAB_RUN_VERSION, type LabRow, type LabRun, type LabSurroundings } from '../results/LabRun';
import type { StageFrames } from './StageFrames';
import { CaseRun } from './CaseRun';
import { Forecast } from './Forecast';
import type { Progress } from './Progress';
import { thumbnailOf } from '../measure/readPicture';

export interface RunOptions {
  readonly frames: Pick<StageFrames, 'stageOf'>;
  readonly surroundings: LabSurroundings;
  /** Called before each step. */
  onProgress?(progress: Progress): void;
  /** Called after each case and awaited, so that the page can draw without disturbing a measurement. */
  onCase?(progress: Progress): void | Promise<void>;
  /** Cancels the run, which then resolves with the rows so far and with `complete` false. */
  readonly signal: AbortSignal;
  /** Maximum number of WebGL contexts; default as for a desktop. */
  readonly mostContexts?: number;
  /** Clock (ms); default `performance.now`. */
  readonly now?: () => number;
  /** Creates the data URL of a run's picture; by default of a reduced copy. */
  readonly thumbnailOf?: (picture: ImageData) => string;
}

/**
 * Measures every competitor in every case, in turns (A B C A B C), and compares their pictures.
 *
 * A competitor that cannot draw a case, or fails, gets a row with a `problem`; the others are measured.
 */
export async function runPlan(plan: LabPlan, options: RunOptions): Promise<LabRun> {
  const { signal, surroundings, mostContexts = MOST_CONTEXTS.desktop, now = () => performance.now() } = options;
  const begin = now();
  const rows: LabRow[] = [];
  const forecast = new Forecast(plan.effort.longestFrame);
  const groups = groupsOf(plan.competitors, mostContexts);
  const cases = plan.series.flatMap((series) => series.cases.map((labCase, index) => ({ series, labCase, index })));
  const progress = progressOf(plan, cases[0], rows);
  const step = (competitor: string | null, picture?: ImageData): void => {
    progress.competitor = competitor;
    progress.picture = picture ?? progress.picture;
    progress.done = Math.min(progress.done + 1, progress.total);
    const passed = now() - begin;
    const left = (passed / progress.done) * (progress.total - progress.done);
    const limit = plan.effort.limit;
    progress.remaining = progress.done < 3 ? null : limit === null ? left : Math.max(0, Math.min(left, limit - passed));
    options.onProgress?.(progress);
  };
  const isLate = (): boolean => plan.effort.limit !== null && now() - begin > plan.effort.limit;
  let measured = 0;
  for (const [at, { series, labCase, index }] of cases.entries()) {
    if (signal.aborted) break;
    Object.assign(progress, { series, labCase });
    const turn = turnLength(plan, begin, now(), at / cases.length);
    const caseRun = new CaseRun({
      ...{ thumbnailOf, ...options, now, isLate },
      ...{ plan, series, labCase, index, rows, forecast, turn, step },
    });
    if (isLate()) {
      caseRun.leaveOut();
      continue;
    }
    for (const group of groups) {
      if (!signal.aborted) await caseRun.measure(group);
    }
    await caseRun.end();
    if (!signal.aborted && !isLate()) measured++;
    await options.onCase?.(progress);
  }
  return {
    format: 'farol-lab-run',
    version: LAB_RUN_VERSION,
    id: `${surroundings.date}-${Math.random().toString(36).slice(2, 8)}`,
    name: '',
    surroundings,
    plan,
    rows,
    complete: measured === cases.length,
    duration: now() - begin,
  };
}

/** Groups of competitors that are open at the same time; one context is left for the reference picture. */
function groupsOf(competitors: readonly string[], mostContexts: number): string[][] {
  const size = Math.max(1, mostContexts - 1);
  const count = Math.ceil(competitors.length / size);
  return Array.from({ length: count }, (_, group) => competitors.filter((_name, index) => index % count === group));
}

/** Length of a turn in a case (ms): shortened if the run at its current pace would exceed the plan's limit. */
function turnLength({ effort }: LabPlan, begin: number, now: number, done: number): number {
  if (effort.limit === null || done === 0) return effort.turn;
  const left = effort.limit - (now - begin);
  const share = left / effort.limit / (1 - done);
  return effort.turn * Math.min(1, Math.max(0, share) ** 2);
}

function progressOf(plan: LabPlan, first: { series: LabSeries; labCase: LabCase }, rows: readonly LabRow[]): Progress {
  const cases = plan.series.reduce((sum, { cases }) => sum + cases.length, 0);
  const steps = 1 + plan.effort.rounds + 1;
  return {
    ...{ done: 0, total: cases * plan.competitors.length * steps, remaining: null, competitor: null },
    ...{ series: first.series, labCase: first.labCase, rows, picture: null },
  };
}
