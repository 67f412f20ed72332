import { t } from '@farol/editing';
import type { LabRun, Metric } from '../results/LabRun';
import { formatMs, formatNumber, formatPercent } from '../words/format';
import { byMetric, competitorLabel, competitorWord, isTechnique } from '../words/names';
import { compareSpreads, timeOf } from '../words/compareSpreads';
import { type Entry, entriesOf } from '../words/rowsOf';
import { casesOf, type SeriesCase } from '../words/seriesCases';
import type { ChartSettings, ChartSpec } from './ChartSpec';
import { competitorOrder } from './competitorMarks';
import { type ChartRow, drawRows } from './drawRows';

/** Loss of `auto` in a case, compared with the best technique. */
interface Regret {
  readonly of: SeriesCase;
  readonly auto: Entry;
  readonly best: Entry;
  /** Technique that `auto` chose; null if the run does not record it. */
  readonly choice: string | null;
  /** `auto`’s time over the best technique’s, less 1: 0.05 for 5% longer. Negative when noise favours `auto`. */
  readonly regret: number;
  readonly isTie: boolean;
}

/** Losses of `auto` against the best of Farol’s techniques, in each case that `auto` and a technique have drawn. */
export function regretsOf(run: LabRun, metric: Metric): Regret[] {
  return casesOf(run).flatMap((of) => {
    const entries = entriesOf(run, of.series, of.index, metric);
    const auto = entries.find(({ competitor }) => competitor === 'auto');
    const best = entries.find(({ competitor }) => isTechnique(competitor));
    if (!auto || !best || !timeOf(auto.row, metric)) return [];
    const regret = auto.time.median / best.time.median - 1;
    return [{ of, auto, best, choice: auto.row.technique, regret, isTie: compareSpreads(auto.time, best.time) === 0 }];
  });
}

/** Bars of what `auto` lost in each case against the best technique; null if it was not measured. */
export function regretChart(run: LabRun, { metric }: ChartSettings, key = 'regret'): ChartSpec | null {
  const regrets = regretsOf(run, metric);
  if (regrets.length === 0) return null;
  const mean = regrets.reduce((sum, { regret }) => sum + regret, 0) / regrets.length;
  const low = Math.min(0, ...regrets.map(({ regret }) => regret));
  const high = Math.max(0.05, ...regrets.map(({ regret }) => regret));
  const rows = regrets.map((each): ChartRow => {
    const { of, regret, choice, isTie } = each;
    const bar = {
      ...{ from: Math.min(0, regret), to: Math.max(0, regret), lane: 0, opacity: isTie ? 0.45 : 1 },
      ...{ fill: (paint: { competitor(name: string): string }) => paint.competitor(choice ?? 'auto') },
      ...{ text: formatPercent(regret), tip: { title: of.label, lines: linesOf(each) } },
    };
    return { label: of.label, bars: [bar], competitor: choice ?? 'auto' };
  });
  return {
    key,
    title: `${t('What auto loses against the best technique')}${byMetric(metric)}`,
    description: t(
      'Time of auto over the time of the fastest technique, less 1, in percent: a bar a case, coloured by the technique that auto chose; pale where the difference is within the spread.',
    ),
    notes: regrets.length > 1 ? [t('The dashed line is the mean. Pale bars lie within the spread.')] : [],
    table: {
      columns: [
        ...[t('Case'), t('auto chose'), 'auto, ms', t('Best technique'), t('Its time, ms')],
        ...[t('Regret'), t('Within the spread')],
      ],
      rows: regrets.map(({ of, choice, auto, best, regret, isTie }) => [
        ...[of.label, choice === null ? '–' : competitorLabel(choice), formatNumber(auto.time.median)],
        ...[
          competitorLabel(best.competitor),
          formatNumber(best.time.median),
          formatPercent(regret),
          isTie ? t('yes') : t('no'),
        ],
      ]),
    },
    legend: [...new Set(regrets.map(({ choice }) => choice ?? 'auto'))].sort(
      (a, b) => competitorOrder(a) - competitorOrder(b),
    ),
    draw: (options) =>
      drawRows(
        {
          ...{ rows, lanes: 1, type: 'linear', domain: [low, high], label: t('Longer than the best technique') },
          ...{ format: formatPercent, rules: [mean] },
        },
        options,
      ),
  };
}

function linesOf({ choice, auto, best, regret, isTie }: Regret): string[] {
  const chose = choice === null ? 'auto' : t('auto chose {name}', { name: competitorWord(choice) });
  const why = auto.row.reason ? [`${t('Why')}: ${t(auto.row.reason)}`] : [];
  return [
    `${chose}: ${formatMs(auto.time.median)}`,
    t('Best: {name}, {time}', { name: competitorWord(best.competitor), time: formatMs(best.time.median) }),
    t(isTie ? 'Regret {share}, within the spread' : 'Regret {share}', { share: formatPercent(regret) }),
    ...why,
  ];
}
