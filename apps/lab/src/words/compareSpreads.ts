import { t } from '@farol/editing';
import type { LabRow, LabRun, Metric, Spread } from '../results/LabRun';
import { isSoftware } from './device';

/** Relative difference of medians that counts as equal, since two runs of one case differ by as much. */
export const SAME = 0.03;

/** Whether a time exists and is positive. */
export function isUsable(spread: Spread | null | undefined): spread is Spread {
  return spread !== null && spread !== undefined && Number.isFinite(spread.median) && spread.median > 0;
}

/** A row's time by a metric; null unless it is usable. */
export function timeOf(row: LabRow | undefined, metric: Metric): Spread | null {
  const spread = row?.[metric];
  return row && row.problem === null && isUsable(spread) ? spread : null;
}

/** Bounds of a spread; the median replaces an unusable bound. */
export function boundsOf({ median, low, high }: Spread): { low: number; high: number } {
  return {
    low: Number.isFinite(low) && low > 0 ? Math.min(low, median) : median,
    high: Number.isFinite(high) ? Math.max(high, median) : median,
  };
}

/**
 * Compares two times. They tie if they differ by 3% at most, or if the median of one lies within the spread (10th to 90th
 * percentile) of the other.
 *
 * @returns -1 if `a` is shorter, 1 if `b` is, 0 for a tie
 */
export function compareSpreads(a: Spread, b: Spread): -1 | 0 | 1 {
  const [shorter, longer] = a.median <= b.median ? [a, b] : [b, a];
  if (longer.median <= shorter.median * (1 + SAME)) return 0;
  if (boundsOf(shorter).high >= longer.median || boundsOf(longer).low <= shorter.median) return 0;
  return shorter === a ? -1 : 1;
}

/** Reason, a sentence, why no run has times by a metric; null if one has. */
export function missingMetric(runs: readonly LabRun[], metric: Metric): string | null {
  if (runs.every(({ rows }) => rows.length === 0)) return null;
  if (runs.some(({ rows }) => rows.some((row) => timeOf(row, metric)))) return null;
  if (metric === 'gpu' && runs.every(({ surroundings: { device } }) => isSoftware(device)))
    return t('No GPU times: a software rasteriser draws on the processor.');
  if (metric === 'gpu') return t('No GPU times: the device or the browser has no timer queries.');
  return metric === 'cpu' ? t('No CPU times were measured.') : t('No frame times were measured.');
}
