import { t, tCount } from '@farol/editing';
import type { LabRun } from '../results/LabRun';
import { formatFactor, formatNumber } from '../words/format';
import { boundsOf, compareSpreads } from '../words/compareSpreads';
import { competitorLabel, competitorWord, metricWords } from '../words/names';
import { caseLabel } from '../words/seriesCases';
import { compareRuns } from '../results/compareRuns';
import type { ChartSettings, ChartSpec } from './ChartSpec';
import { competitorOrder } from './competitorMarks';
import { type ChartRow, drawRows } from './drawRows';
import { logTicks } from './scales';

/** Ratios of a run's times to another run's, by competitor; null if they have no case in common. */
export function ratioChart(
  [base, baseName]: readonly [LabRun, string],
  [run, name]: readonly [LabRun, string],
  { metric, scale }: ChartSettings,
  key = 'ratio',
): ChartSpec | null {
  const compared = compareRuns(run, base, metric);
  const ratios = compared.rows.flatMap(({ competitor, series, index, times, ratio }) => {
    if (!times || ratio === null) return [];
    const [bounds, baseBounds] = times.map(boundsOf);
    return {
      ...{ competitor, ratio, label: caseLabel(series, index), isTie: compareSpreads(...times) === 0 },
      ...{ low: bounds.low / baseBounds.high, high: bounds.high / baseBounds.low },
    };
  });
  if (ratios.length === 0) return null;
  const competitors = compared.competitors
    .filter(({ cases }) => cases > 0)
    .sort((a, b) => competitorOrder(a.competitor) - competitorOrder(b.competitor));
  const lowest = Math.min(1, ...ratios.map(({ ratio }) => ratio));
  const highest = Math.max(1, ...ratios.map(({ ratio }) => ratio));
  const domain: [number, number] = scale === 'log' ? [lowest / 1.1, highest * 1.1] : [0, highest * 1.05];
  const rows = competitors.map(({ competitor, cases, ratio }): ChartRow => {
    const sorted = ratios.filter((each) => each.competitor === competitor).sort((a, b) => a.ratio - b.ratio);
    const [lowestCase, highestCase] = [sorted[0], sorted.at(-1)!];
    const mean = ratio!;
    const lines = [
      tCount(cases, '{factor} as long over one figure', '{factor} as long over {count} figures', {
        factor: formatFactor(mean),
      }),
      t('{low} to {high}', {
        low: `${formatNumber(lowestCase.ratio)} (${lowestCase.label})`,
        high: `${formatNumber(highestCase.ratio)} (${highestCase.label})`,
      }),
    ];
    const tip = { title: competitorLabel(competitor), lines };
    const fill = (paint: { competitor(name: string): string }): string => paint.competitor(competitor);
    return {
      ...{ label: competitorWord(competitor), competitor },
      bars: [
        { from: lowestCase.ratio, to: highestCase.ratio, lane: 0, opacity: 0.35, fill, tip, text: formatNumber(mean) },
      ],
      marks: [{ value: mean, competitor, lane: 0, tip }],
    };
  });
  return {
    key,
    title: t('{a} over {b}', { a: name, b: baseName }),
    description: t(
      '{time} time of {a} over that of {b}, a row a competitor: the bar from the least ratio to the greatest, the symbol at the geometric mean; 1 is equal.',
      { time: t(metricWords[metric].label), a: name, b: baseName },
    ),
    notes: [t('Bars run from the least ratio of a case to the greatest; symbols and numbers are geometric means.')],
    table: {
      columns: [t('Case'), t('Competitor'), t('Ratio'), t('By the spreads'), t('Within the spread')],
      rows: ratios.map(({ label, competitor, ratio, low, high, isTie }) => [
        ...[label, competitorLabel(competitor), formatNumber(ratio)],
        ...[t('{low} to {high}', { low: formatNumber(low), high: formatNumber(high) }), isTie ? t('yes') : t('no')],
      ]),
    },
    draw: (options) =>
      drawRows(
        {
          ...{ rows, lanes: 1, type: scale, domain, label: t('Times as long'), format: (value) => formatNumber(value) },
          ...{ rules: [1], ticks: scale === 'log' ? (most) => ratioTicks(domain, most) : undefined },
        },
        options,
      ),
  };
}

/** Ticks that include 1, closer together for ratios near 1. */
function ratioTicks([low, high]: readonly [number, number], most: number): number[] {
  const ticks = logTicks(low, high, most);
  if (ticks.length > 2) return ticks;
  const fine = [0.5, 0.6, 0.7, 0.8, 0.9, 1, 1.1, 1.2, 1.3, 1.5, 1.7, 2, 2.5, 3].filter((t) => t >= low && t <= high);
  return fine.length <= most
    ? fine
    : fine.filter((_, i) => i % Math.ceil(fine.length / most) === fine.indexOf(1) % Math.ceil(fine.length / most));
}
