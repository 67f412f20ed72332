import type { LabSeries } from '../plan/LabPlan';
import type { LabRun, Metric } from '../results/LabRun';
import { compareSpreads } from './compareSpreads';
import { entriesOf, type Entry } from './rowsOf';

/** Fastest competitors of a case: several if their spreads overlap, the shortest median first. */
export interface Winners {
  readonly index: number;
  readonly value: number;
  readonly best: Entry;
  /** Keys of the fastest competitor and of those that tie with it. */
  readonly names: readonly string[];
  /** Times of all competitors except `auto`, shortest first. */
  readonly entries: readonly Entry[];
}

/** Fastest competitors of a case; `auto`, which draws by another technique, is left out; null if none has a time. */
export function winnersOf(run: LabRun, series: LabSeries, index: number, metric: Metric): Winners | null {
  const entries = entriesOf(run, series, index, metric).filter(({ competitor }) => competitor !== 'auto');
  if (entries.length === 0) return null;
  const [best] = entries;
  const names = entries.filter(({ time }) => compareSpreads(best.time, time) === 0).map(({ competitor }) => competitor);
  return { index, value: series.values[index], best, names, entries };
}
