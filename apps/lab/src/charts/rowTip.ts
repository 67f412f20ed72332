import type { LabSeries } from '../plan/LabPlan';
import type { LabRow, Metric } from '../results/LabRun';
import { boundsOf, timeOf } from '../words/compareSpreads';
import { formatBytes, formatMs, formatNumber } from '../words/format';
import { competitorLabel, competitorWord, metricWords, valueText } from '../words/names';
import type { ChartTip } from './ChartSpec';

/** Figures of a row as the note at its point. */
export function rowTip(row: LabRow, series: LabSeries, metric: Metric, runName = ''): ChartTip {
  const value = valueText(series.axis, series.values[row.index], series.cases[row.index]);
  const title = `${competitorLabel(row.competitor)}, ${value}${runName ? ` (${runName})` : ''}`;
  return { title, lines: rowLines(row, metric) };
}

/** Times, likeness of the picture, counts and warnings. */
function rowLines(row: LabRow, metric: Metric): string[] {
  if (row.problem !== null) return [row.problem];
  const time = timeOf(row, metric);
  const lines: string[] = [];
  if (time) {
    const { low, high } = boundsOf(time);
    lines.push(
      `${metricWords[metric].label}: ${formatMs(time.median)} median, ${formatNumber(low)} to ${formatMs(high)} (${time.samples} samples)`,
    );
  }
  const others = (['frame', 'gpu', 'cpu'] as const).filter((other) => other !== metric && timeOf(row, other));
  if (others.length > 0) {
    lines.push(others.map((other) => `${metricWords[other].label} ${formatMs(timeOf(row, other)!.median)}`).join(', '));
  }
  if (row.technique && row.technique !== row.competitor)
    lines.push(`Drawn by ${competitorWord(row.technique)}${row.reason ? `: ${row.reason}` : ''}`);
  if (row.likeness) {
    const { psnr, reference } = row.likeness;
    const like = psnr === null ? 'equal to' : `${formatNumber(psnr)} dB PSNR against`;
    lines.push(`Picture ${like} ${competitorWord(reference)}`);
  }
  if (row.dropped > 0) lines.push(`${formatNumber(row.dropped, 6)} lights are left out`);
  const counts = [
    row.counts?.draws == null ? '' : `${formatNumber(row.counts.draws, 6)} draws`,
    row.counts?.programs == null ? '' : `${formatNumber(row.counts.programs, 6)} programs`,
    row.counts?.targetBytes == null ? '' : `${formatBytes(row.counts.targetBytes)} of targets`,
  ].filter(Boolean);
  if (counts.length > 0) lines.push(counts.join(', '));
  return [...lines, ...row.warnings.map((warning) => `Doubtful: ${warning}`)];
}
