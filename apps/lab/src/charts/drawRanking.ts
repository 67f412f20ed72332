import { t } from '@farol/editing';
import { formatMs, formatNumber } from '../words/format';
import { competitorWord, metricWords } from '../words/names';
import type { ChartSettings, DrawnChart, DrawOptions } from './ChartSpec';
import type { Curve } from './curveData';
import { type ChartRow, drawRows, type RowBar } from './drawRows';
import { rowTip } from './rowTip';

/** Bars of a series with a single case, shortest time first, in place of curves of one point. */
export function drawRanking(
  curves: readonly Curve[],
  runNames: readonly string[],
  { metric, scale }: Pick<ChartSettings, 'metric' | 'scale'>,
  options: DrawOptions,
): DrawnChart {
  const lanes = Math.max(...curves.map(({ run }) => run)) + 1;
  const medians = curves.map(({ points }) => points[0].median);
  const domain: [number, number] = [scale === 'log' ? Math.min(...medians) / 1.5 : 0, Math.max(...medians)];
  const competitors = [...new Set(curves.map(({ competitor }) => competitor))];
  const rows = competitors
    .map((competitor) => curves.filter((curve) => curve.competitor === competitor))
    .sort((a, b) => a[0].points[0].median - b[0].points[0].median)
    .map((byRun): ChartRow => {
      const { competitor } = byRun[0];
      const bars = byRun.map(({ run, series, points: [{ median, row }] }): RowBar => {
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
  const label = `${t(metricWords[metric].label)} (ms)`;
  return drawRows({ rows, lanes, type: scale, domain, label, format: (ms) => formatNumber(ms) }, options);
}
