import { formatMs, formatNumber } from '../words/format';
import { competitorWord, metricWords } from '../words/names';
import { logTicks } from './axisTicks';
import type { ChartSettings, DrawnChart, DrawOptions } from './ChartSpec';
import type { Curve } from './curveData';
import { drawEmpty } from './drawEmpty';
import { type ChartRow, drawRows, type RowBar } from './drawRows';
import { rowTip } from './rowTip';

/** Bars of a series of one case, the shortest time first: a curve of one point says less. */
export function drawRanking(
  curves: readonly Curve[],
  runNames: readonly string[],
  { metric, scale }: Pick<ChartSettings, 'metric' | 'scale'>,
  options: DrawOptions,
): DrawnChart {
  if (curves.length === 0) return drawEmpty(options.width, options.paint, options.document ?? globalThis.document);
  const lanes = Math.max(...curves.map(({ run }) => run)) + 1;
  const medians = curves.map(({ points }) => points[0].median);
  const domain: [number, number] = [scale === 'log' ? Math.min(...medians) / 1.5 : 0, Math.max(...medians)];
  const competitors = [...new Set(curves.map(({ competitor }) => competitor))];
  const rows = competitors
    .map((competitor) => curves.filter((curve) => curve.competitor === competitor))
    .sort((a, b) => a[0].points[0].median - b[0].points[0].median)
    .map((own): ChartRow => {
      const { competitor } = own[0];
      const bars = own.map(({ run, series, points: [{ median, row }] }): RowBar => {
        const tip = rowTip(row, series, metric, runNames.length > 1 ? runNames[run] : '');
        const fill: RowBar['fill'] = (paint) => paint.competitor(competitor);
        return {
          from: domain[0],
          to: median,
          lane: run,
          opacity: run === 0 ? 1 : 0.5,
          fill,
          tip,
          text: formatMs(median),
        };
      });
      return { label: competitorWord(competitor), competitor, bars };
    });
  const label = `${metricWords[metric].label} (ms)`;
  const ticks = scale === 'log' ? logTicks(domain[0], domain[1], options.width < 520 ? 4 : 8) : undefined;
  return drawRows({ rows, lanes, type: scale, domain, label, ticks, format: (ms) => formatNumber(ms) }, options);
}
