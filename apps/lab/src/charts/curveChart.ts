import { isNamed, type LabSeries } from '../plan/LabPlan';
import { axisLabel } from '../plan/sceneWords';
import type { LabRow, LabRun, Metric } from '../results/LabRun';
import { boundsOf, timeOf } from '../words/compareSpreads';
import { curveWords, sizeText } from '../words/curveWords';
import { formatNumber, listOf } from '../words/format';
import { competitorLabel, competitorWord, metricWords, valueText } from '../words/names';
import { rowsOf } from '../words/rowsOf';
import { seriesWord } from '../words/seriesCases';
import type { ChartSettings, ChartSpec, ChartTable } from './ChartSpec';
import { type Curve, curvesOf } from './curveData';
import { drawCurves } from './drawCurves';
import { drawRanking } from './drawRanking';
import { runNames } from './runNames';

/** Times of every competitor along a series. */
export function curveChart(runs: readonly LabRun[], series: LabSeries, settings: ChartSettings): ChartSpec {
  const { metric } = settings;
  const names = runNames(runs);
  const curves = curvesOf(runs, series, metric);
  const planned = runs.flatMap(({ plan }) => plan.series.find(({ name }) => name === series.name) ?? []);
  const size = listOf([...new Set(planned.map(({ cases }) => sizeText(cases)))].filter(Boolean));
  const kind = settings.scale === 'log' ? 'logarithmic axes' : 'linear axes';
  const along = axisLabel(series).toLowerCase();
  const how = isNamed(series.axis)
    ? `by ${along}, a column a case, a symbol a competitor; its line runs`
    : `over ${along}, ${kind}, a line a competitor; bands run`;
  return {
    key: `curve-${series.name}`,
    title: `${isOneCase(curves) ? caseText(series) : series.label}${size ? `, ${size}` : ''}`,
    description: isOneCase(curves)
      ? `${metricWords[metric].label} times in milliseconds, a bar a competitor, the shortest first.`
      : `${metricWords[metric].label} times in milliseconds ${how} from the 10th to the 90th percentile.`,
    sentences: runs.flatMap((run, i) => {
      const own = run.plan.series.find(({ name }) => name === series.name);
      const sentences = own ? curveWords(run, own, metric) : [];
      return runs.length > 1 && sentences.length > 0
        ? [`${names[i]}: ${sentences[0]}`, ...sentences.slice(1, 2)]
        : sentences;
    }),
    verdicts: [],
    notes: notesOf(runs, series, metric),
    table: tableOf(runs, names, series, metric),
    legend: [...new Set(curves.map(({ competitor }) => competitor))],
    keys: [],
    runs: runs.length > 1 ? names : [],
    choice: null,
    wide: false,
    draw: (options) =>
      isOneCase(curves)
        ? drawRanking(curves, names, settings, options)
        : drawCurves(series, curves, names, settings, options),
  };
}

/** A series of one case by its scene and value; pixels are told by the size. */
function caseText(series: LabSeries): string {
  return series.axis === 'pixels'
    ? seriesWord(series)
    : `${seriesWord(series)}, ${valueText(series.axis, series.values[0])}`;
}

/** Whether every run planned one case alone, and the same. */
function isOneCase(curves: readonly Curve[]): boolean {
  return new Set(curves.flatMap((curve) => curve.series.values)).size === 1;
}

/** Whose times are missing by this metric though they have others. */
function notesOf(runs: readonly LabRun[], series: LabSeries, metric: Metric): string[] {
  if (metric === 'frame') return [];
  const without = new Set<string>();
  for (const run of runs) {
    for (const [competitor, rows] of rowsOf(run, series)) {
      if (rows.some((row) => timeOf(row, 'frame')) && !rows.some((row) => timeOf(row, metric))) without.add(competitor);
    }
  }
  return without.size === 0 ? [] : [`No ${metricWords[metric].noun} for ${listOf([...without].map(competitorWord))}.`];
}

function tableOf(runs: readonly LabRun[], names: readonly string[], series: LabSeries, metric: Metric): ChartTable {
  const planned = runs.map(({ plan }) => plan.series.find(({ name }) => name === series.name));
  const cases = new Map<number, string>();
  for (const own of planned) {
    own?.values.forEach((value, i) => {
      if (!cases.has(value)) cases.set(value, valueText(own.axis, value, own.cases[i]));
    });
  }
  const values = [...cases.keys()].sort((a, b) => a - b);
  const rows = runs.flatMap((run, i) => {
    const own = planned[i];
    if (!own) return [];
    return [...rowsOf(run, own)].map(([competitor, list]) => [
      runs.length > 1 ? `${competitorLabel(competitor)} (${names[i]})` : competitorLabel(competitor),
      ...values.map((value) => cellOf(list[own.values.indexOf(value)], metric)),
    ]);
  });
  return { columns: [`${metricWords[metric].label}: median (spread), ms`, ...values.map((v) => cases.get(v)!)], rows };
}

/** A time with its spread and warnings, or why there is none. */
function cellOf(row: LabRow | undefined, metric: Metric): string {
  const time = timeOf(row, metric);
  if (!row || !time) return row?.problem ?? '–';
  const { low, high } = boundsOf(time);
  const text = `${formatNumber(time.median)} (${formatNumber(low)} to ${formatNumber(high)})`;
  return row.warnings.length > 0 ? `${text}; ${row.warnings.join(' ')}` : text;
}
