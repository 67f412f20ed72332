import { t } from '@farol/editing';
import { isNamed, type LabCase, type LabSeries } from '../plan/LabPlan';
import { axisLabel } from '../plan/sceneWords';
import type { LabRow, LabRun, Metric } from '../results/LabRun';
import { boundsOf, timeOf } from '../words/compareSpreads';
import { formatNumber, listOf } from '../words/format';
import { competitorLabel, competitorWord, metricWords, valueText } from '../words/names';
import { rowsOf } from '../words/rowsOf';
import { seriesLabel, seriesWord } from '../words/seriesLabel';
import type { ChartSettings, ChartSpec, ChartTable, DrawnChart, DrawOptions } from './ChartSpec';
import { type Curve, curvesOf } from './curveData';
import { drawCurves } from './drawCurves';
import { drawRanking } from './drawRanking';
import { runNames } from './runNames';
import { textTag } from './svg';

/** Chart of the times of every competitor along a series. */
export function curveChart(runs: readonly LabRun[], series: LabSeries, settings: ChartSettings): ChartSpec {
  const { metric } = settings;
  const names = runNames(runs);
  const curves = curvesOf(runs, series, metric);
  const planned = runs.flatMap(({ plan }) => plan.series.find(({ name }) => name === series.name) ?? []);
  const size = listOf([...new Set(planned.map(({ cases }) => sizeText(cases)))].filter(Boolean));
  const kind = settings.scale === 'log' ? t('logarithmic axes') : t('linear axes');
  const along = axisLabel(series).toLowerCase();
  const time = t(metricWords[metric].label);
  const how = isNamed(series.axis)
    ? t(
        '{time} times in milliseconds by {along}, a column a case, a symbol a competitor; its line runs from the 10th to the 90th percentile.',
        { time, along },
      )
    : t(
        '{time} times in milliseconds over {along}, {kind}, a line a competitor; bands run from the 10th to the 90th percentile.',
        { time, along, kind },
      );
  return {
    key: `curve-${series.name}`,
    title: `${isOneCase(curves) ? caseText(series) : seriesLabel(series)}${size ? `, ${size}` : ''}`,
    description: isOneCase(curves)
      ? t('{time} times in milliseconds, a bar a competitor, the shortest first.', { time })
      : how,
    notes: notesOf(runs, series, metric),
    table: tableOf(runs, names, series, metric),
    legend: [...new Set(curves.map(({ competitor }) => competitor))],
    runs: runs.length > 1 ? names : [],
    draw: (options) => {
      if (curves.length === 0) return drawEmpty(options);
      return isOneCase(curves)
        ? drawRanking(curves, names, settings, options)
        : drawCurves(series, curves, names, settings, options);
    },
  };
}

/** Title of a series of one case: scene and value; only the scene along pixels, since the title ends with the size. */
function caseText(series: LabSeries): string {
  return series.axis === 'pixels'
    ? seriesWord(series)
    : `${seriesWord(series)}, ${valueText(series.axis, series.values[0])}`;
}

/** Whether the curves of all runs have one and the same value: a single case. */
function isOneCase(curves: readonly Curve[]): boolean {
  return new Set(curves.flatMap((curve) => curve.series.values)).size === 1;
}

/** Notes that name the competitors without any time in the series, one note for each reason. */
function notesOf(runs: readonly LabRun[], series: LabSeries, metric: Metric): string[] {
  const without = new Map<string, Set<string>>();
  for (const run of runs) {
    for (const [competitor, rows] of rowsOf(run, series)) {
      if (rows.some((row) => timeOf(row, metric)) || !rows.some(Boolean)) continue;
      const isTimed = rows.some((row) => timeOf(row, 'frame'));
      const what = isTimed ? t(metricWords[metric].noun) : t('figure');
      const reason = isTimed ? '.' : `: ${t(rows.find((row) => row?.problem)?.problem ?? 'unknown reason.')}`;
      const key = JSON.stringify([what, reason]);
      without.set(key, (without.get(key) ?? new Set()).add(competitorWord(competitor)));
    }
  }
  return [...without].map(([key, names]) => {
    const [what, reason] = JSON.parse(key) as [string, string];
    return `${t('No {what} for {names}', { what, names: listOf([...names]) })}${reason}`;
  });
}

/** Size of the pictures, as `1280 × 720`; empty if the series has several sizes. */
function sizeText(cases: readonly LabCase[]): string {
  // the sizes have no-break spaces, so that a line does not end within a size
  const sizes = new Set(cases.map(({ width, height }) => `${width}\u00a0×\u00a0${height}`));
  return sizes.size === 1 ? [...sizes][0] : '';
}

/** Drawing of a series in which nothing was measured. */
function drawEmpty({ width, paint }: DrawOptions): DrawnChart {
  const style = { x: width / 2, y: 40, fill: paint.dim, 'font-size': 13 };
  return { height: 80, svg: textTag(t('No figures here'), style), points: [] };
}

function tableOf(runs: readonly LabRun[], names: readonly string[], series: LabSeries, metric: Metric): ChartTable {
  const planned = runs.map(({ plan }) => plan.series.find(({ name }) => name === series.name));
  const cases = new Map<number, string>();
  for (const each of planned) {
    each?.values.forEach((value, i) => {
      if (!cases.has(value)) cases.set(value, valueText(each.axis, value, each.cases[i]));
    });
  }
  const values = [...cases.keys()].sort((a, b) => a - b);
  const rows = runs.flatMap((run, i) => {
    const plan = planned[i];
    if (!plan) return [];
    return [...rowsOf(run, plan)].map(([competitor, list]) => [
      runs.length > 1 ? `${competitorLabel(competitor)} (${names[i]})` : competitorLabel(competitor),
      ...values.map((value) => cellOf(list[plan.values.indexOf(value)], metric)),
    ]);
  });
  return {
    columns: [
      t('{time}: median (spread), ms', { time: t(metricWords[metric].label) }),
      ...values.map((v) => cases.get(v)!),
    ],
    rows,
  };
}

/** A time with its spread and warnings, or the reason why there is none. */
function cellOf(row: LabRow | undefined, metric: Metric): string {
  const time = timeOf(row, metric);
  if (!row || !time) return row?.problem ?? '–';
  const { low, high } = boundsOf(time);
  const text = `${formatNumber(time.median)} (${t('{low} to {high}', { low: formatNumber(low), high: formatNumber(high) })})`;
  return row.warnings.length > 0 ? `${text}; ${row.warnings.join(' ')}` : text;
}
