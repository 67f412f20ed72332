import { t } from '@farol/editing';
import type { LabSeries } from '../plan/LabPlan';
import type { LabRow, Metric } from '../results/LabRun';
import { boundsOf, timeOf } from '../words/compareSpreads';
import { formatBytes, formatMs, formatNumber } from '../words/format';
import { competitorLabel, competitorWord, metricWords, valueText } from '../words/names';
import type { ChartTip } from './ChartSpec';

/** Text of the note at a point: the measurements of the point's row. */
export function rowTip(row: LabRow, series: LabSeries, metric: Metric, runName = ''): ChartTip {
  const value = valueText(series.axis, series.values[row.index], series.cases[row.index]);
  const title = `${competitorLabel(row.competitor)}, ${value}${runName ? ` (${runName})` : ''}`;
  return { title, lines: rowLines(row, metric) };
}

/** Lines of the note: times, likeness of the picture, counts and warnings. */
function rowLines(row: LabRow, metric: Metric): string[] {
  if (row.problem !== null) return [t(row.problem)];
  const time = timeOf(row, metric);
  const lines: string[] = [];
  if (time) {
    const { low, high } = boundsOf(time);
    lines.push(
      t('{time}: {median} median, {low} to {high} ({samples} samples)', {
        time: t(metricWords[metric].label),
        median: formatMs(time.median),
        low: formatNumber(low),
        high: formatMs(high),
        samples: time.samples,
      }),
    );
  }
  const others = (['frame', 'gpu', 'cpu'] as const).filter((other) => other !== metric && timeOf(row, other));
  if (others.length > 0) {
    lines.push(
      others.map((other) => `${t(metricWords[other].label)} ${formatMs(timeOf(row, other)!.median)}`).join(', '),
    );
  }
  if (row.technique && row.technique !== row.competitor)
    lines.push(
      `${t('Drawn by {name}', { name: competitorWord(row.technique) })}${row.reason ? `: ${t(row.reason)}` : ''}`,
    );
  if (row.likeness) {
    const { psnr, reference } = row.likeness;
    const name = competitorWord(reference);
    lines.push(
      psnr === null
        ? t('Picture equal to {name}', { name })
        : t('Picture {psnr} dB PSNR against {name}', { psnr: formatNumber(psnr), name }),
    );
  }
  if (row.dropped > 0) lines.push(t('{count} lights are left out', { count: formatNumber(row.dropped, 6) }));
  const counts = [
    row.counts?.draws == null ? '' : t('{count} draws', { count: formatNumber(row.counts.draws, 6) }),
    row.counts?.programs == null ? '' : t('{count} programs', { count: formatNumber(row.counts.programs, 6) }),
    row.counts?.targetBytes == null ? '' : t('{size} of targets', { size: formatBytes(row.counts.targetBytes) }),
  ].filter(Boolean);
  if (counts.length > 0) lines.push(counts.join(', '));
  return [...lines, ...row.warnings.map((warning) => t('Doubtful: {warning}', { warning: t(warning) }))];
}
