import type { LabSeries } from '../plan/LabPlan';
import type { LabRun, Metric } from '../results/LabRun';
import { compareSpreads } from './compareSpreads';
import { entriesOf, type Entry } from './rowsOf';

/** Who is fastest in a case: several where the spreads do not tell them apart, the shortest median first. */
export interface Winners {
  readonly index: number;
  readonly value: number;
  readonly best: Entry;
  /** Keys of the fastest and of all that tie with it. */
  readonly names: readonly string[];
  /** Everybody's times, shortest first. */
  readonly entries: readonly Entry[];
}

/** The fastest of a case, `auto` left out: it draws by one of the others. Null where nobody has a time. */
export function winnersOf(run: LabRun, series: LabSeries, index: number, metric: Metric): Winners | null {
  const entries = entriesOf(run, series, index, metric).filter(({ competitor }) => competitor !== 'auto');
  if (entries.length === 0) return null;
  const [best] = entries;
  const names = entries.filter(({ time }) => compareSpreads(best.time, time) === 0).map(({ competitor }) => competitor);
  return { index, value: series.values[index], best, names, entries };
}
