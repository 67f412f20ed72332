import type { LabSeries } from '../plan/LabPlan';
import type { LabRow, LabRun, Metric, Spread } from '../results/LabRun';
import { timeOf } from './compareSpreads';

/** Rows of a series by competitor: a list with an entry per case, undefined for unmeasured cases. */
export function rowsOf(run: LabRun, series: LabSeries): ReadonlyMap<string, readonly (LabRow | undefined)[]> {
  const rows = new Map<string, (LabRow | undefined)[]>();
  const listOf = (competitor: string) => {
    const list = rows.get(competitor) ?? Array.from<LabRow | undefined>({ length: series.cases.length });
    rows.set(competitor, list);
    return list;
  };
  for (const competitor of run.plan.competitors) listOf(competitor);
  for (const row of run.rows) {
    if (row.series === series.name && row.index >= 0 && row.index < series.cases.length) {
      listOf(row.competitor)[row.index] = row;
    }
  }
  return rows;
}

/** A competitor's time in a case. */
export interface Entry {
  readonly competitor: string;
  readonly time: Spread;
  readonly row: LabRow;
}

/** Times of all competitors in a case of a series, shortest first. */
export function entriesOf(run: LabRun, series: LabSeries, index: number, metric: Metric): Entry[] {
  return [...rowsOf(run, series)]
    .flatMap(([competitor, rows]) => {
      const row = rows[index];
      const time = timeOf(row, metric);
      return row && time ? [{ competitor, time, row }] : [];
    })
    .sort((a, b) => a.time.median - b.time.median);
}
