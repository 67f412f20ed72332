import type { LabRun, Metric } from '../results/LabRun';
import { isSoftware } from './isSoftware';
import { timeOf } from './compareSpreads';

/** Why no run has times by a metric, as a sentence; null where one has. */
export function missingMetric(runs: readonly LabRun[], metric: Metric): string | null {
  if (runs.every(({ rows }) => rows.length === 0)) return null;
  if (runs.some(({ rows }) => rows.some((row) => timeOf(row, metric)))) return null;
  if (metric === 'gpu' && runs.every(isSoftware)) return 'No GPU times: a software rasteriser draws on the processor.';
  if (metric === 'gpu') return 'No GPU times: the device or the browser has no timer queries.';
  return metric === 'cpu' ? 'No CPU times were measured.' : 'No frame times were measured.';
}
