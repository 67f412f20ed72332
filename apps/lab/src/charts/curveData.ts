import type { LabSeries } from '../plan/LabPlan';
import type { LabRow, LabRun, Metric } from '../results/LabRun';
import { boundsOf, timeOf } from '../words/compareSpreads';
import { rowsOf } from '../words/rowsOf';
import { competitorOrder } from './competitorMarks';

export interface CurvePoint {
  readonly value: number;
  readonly index: number;
  readonly median: number;
  readonly low: number;
  readonly high: number;
  readonly row: LabRow;
}

/** A competitor's times in a series of a run. */
export interface Curve {
  readonly competitor: string;
  /** Index of the run. */
  readonly run: number;
  /** The series as that run planned it: another run may have other values. */
  readonly series: LabSeries;
  /** Connected parts of the curve; a case without a time separates two of them. */
  readonly pieces: readonly (readonly CurvePoint[])[];
  readonly points: readonly CurvePoint[];
  /** Reason, a sentence, why the curve ends before the last case; null if it does not, or if the run has no reason. */
  readonly end: string | null;
}

/** Curves of a series: of each run that has it, in the order of the competitors. */
export function curvesOf(runs: readonly LabRun[], series: LabSeries, metric: Metric): Curve[] {
  return runs
    .flatMap((run, place) => {
      const planned = run.plan.series.find(({ name }) => name === series.name);
      if (!planned) return [];
      return [...rowsOf(run, planned)].map(([competitor, rows]) => curveOf(competitor, place, planned, rows, metric));
    })
    .filter(({ points }) => points.length > 0)
    .sort((a, b) => competitorOrder(a.competitor) - competitorOrder(b.competitor) || a.run - b.run);
}

function curveOf(
  competitor: string,
  run: number,
  series: LabSeries,
  rows: readonly (LabRow | undefined)[],
  metric: Metric,
): Curve {
  const pieces: CurvePoint[][] = [];
  let gap = true;
  let problem: string | null = null;
  rows.forEach((row, index) => {
    const time = timeOf(row, metric);
    if (row && time) {
      if (gap) pieces.push([]);
      pieces.at(-1)!.push({ value: series.values[index], index, median: time.median, ...boundsOf(time), row });
    }
    gap = time === null;
    problem = time ? null : (problem ?? row?.problem ?? null);
  });
  return { competitor, run, series, pieces, points: pieces.flat(), end: problem };
}
