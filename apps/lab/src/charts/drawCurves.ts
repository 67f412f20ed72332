import { t } from '@farol/editing';
import { isNamed, type LabSeries } from '../plan/LabPlan';
import { axisLabel } from '../plan/sceneWords';
import { formatNumber } from '../words/format';
import { competitorWord, metricWords } from '../words/names';
import { axisX, axisY } from './axes';
import { runDashes } from './chartPaint';
import type { ChartPoint, ChartSettings, DrawnChart, DrawOptions } from './ChartSpec';
import { competitorSymbol } from './competitorSymbol';
import type { Curve } from './curveData';
import { rowTip } from './rowTip';
import { linearTicks, logTicks, type Scale, scaleOf, ticksWithRoom, valueTick } from './scales';
import { spreadLabels } from './spreadLabels';
import { tag, textTag, textWidth } from './svg';

interface Place {
  readonly x: Scale;
  readonly y: Scale;
}

/** Draws curves with bands of spread; names are beside the ends of the lines if there is space. */
export function drawCurves(
  series: LabSeries,
  curves: readonly Curve[],
  runNames: readonly string[],
  { metric, scale: kind }: Pick<ChartSettings, 'metric' | 'scale'>,
  { width, paint }: DrawOptions,
): DrawnChart {
  const height = Math.round(Math.min(480, Math.max(280, width * 0.6)));
  const named = curves.filter(({ competitor }, i) => curves.findIndex((each) => each.competitor === competitor) === i);
  const isLabelled = width >= 520 && (named.length - 1) * 13 <= height - 48;
  const nameWidth = Math.max(0, ...named.map(({ competitor }) => textWidth(competitorWord(competitor))));
  const { low, high } = timeBounds(curves, kind);
  const count = Math.floor(height / 34);
  const timeTicks = kind === 'log' ? logTicks(low, high, count) : linearTicks(low, high, count);
  const left = Math.max(40, Math.max(...timeTicks.map((ms) => textWidth(formatNumber(ms)))) + 16);
  const area = { width, height, top: 26, bottom: 42, left, right: isLabelled ? nameWidth + 26 : 18 };
  const values = [...new Set([...series.values, ...curves.flatMap((curve) => curve.series.values)])].sort(
    (a, b) => a - b,
  );
  const place: Place = {
    x: valueScale(series, values, kind, [area.left + 10, width - area.right - 6]),
    y: scaleOf(kind, [low, high], [height - area.bottom, area.top]),
  };
  const room = 12 + Math.max(...values.map((value) => textWidth(valueTick(series, value))));
  const axes = [
    axisY(
      {
        ...{ ticks: timeTicks, scale: place.y, format: formatNumber },
        label: `↑ ${t(metricWords[metric].label)} (ms)`,
      },
      area,
      paint,
    ),
    axisX(
      {
        ...{ ticks: ticksWithRoom(values, place.x, room), scale: place.x },
        format: (value) => valueTick(series, value),
        label: isNamed(series.axis) ? axisLabel(series) : `${axisLabel(series)} →`,
      },
      area,
      paint,
    ),
  ];
  const groups = (draw: (curve: Curve, colour: string) => readonly string[]): string[] =>
    curves.map((curve, i) =>
      tag(
        'g',
        { class: `group group-${i}`, 'aria-hidden': 'true' },
        ...draw(curve, paint.competitor(curve.competitor)),
      ),
    );
  const isList = isNamed(series.axis);
  const bands = groups((curve, colour) => (isList ? [] : bandsOf(curve, colour, place)));
  const lines = groups((curve, colour) => [
    ...(isList ? rangesOf(curve, colour, place) : linesOf(curve, colour, place)),
    ...curve.points.map(({ value, median }) =>
      competitorSymbol(curve.competitor, place.x(value), place.y(median), 4, paint),
    ),
    ...marksOf(curve, colour, place, isList),
  ]);
  const labels = isLabelled ? endLabels(named, curves, place, area, paint) : [];
  const points = curves.flatMap((curve, i) =>
    curve.points.map((point): ChartPoint => {
      const tip = rowTip(point.row, curve.series, metric, runNames.length > 1 ? runNames[curve.run] : '');
      const isLast = point === curve.points.at(-1) && curve.end !== null;
      return {
        ...{ x: place.x(point.value), y: place.y(point.median), group: String(i), order: point.index },
        tip: isLast ? { ...tip, lines: [...tip.lines, `Ends here: ${curve.end}`] } : tip,
      };
    }),
  );
  return { height, svg: [...axes, ...bands, ...lines, ...labels].join(''), points };
}

const at = (x: number, y: number): string => `${x.toFixed(2)},${y.toFixed(2)}`;

/** Filled areas between the 10th and the 90th percentile of a curve's times, one for each connected part. */
function bandsOf({ pieces }: Curve, fill: string, { x, y }: Place): string[] {
  return pieces.map((piece) => {
    const upper = piece.map(({ value, high }) => at(x(value), y(high)));
    const lower = piece.toReversed().map(({ value, low }) => at(x(value), y(low)));
    return tag('path', { d: `M${[...upper, ...lower].join('L')}Z`, fill, 'fill-opacity': 0.13 });
  });
}

function linesOf({ pieces, competitor, run }: Curve, stroke: string, { x, y }: Place): string[] {
  return pieces.map((piece) =>
    tag('path', {
      ...{ d: `M${piece.map(({ value, median }) => at(x(value), y(median))).join('L')}`, fill: 'none', stroke },
      ...{ 'stroke-width': competitor === 'auto' ? 2.6 : 1.8, 'stroke-dasharray': runDashes[run % runDashes.length] },
      'stroke-linejoin': 'round',
    }),
  );
}

/** Spreads as vertical lines, for axes of names: names have no order, so points are not connected. */
function rangesOf({ points }: Curve, stroke: string, { x, y }: Place): string[] {
  return points.map(({ value, low, high }) =>
    tag('path', {
      d: `M${at(x(value), y(low))}V${y(high).toFixed(2)}`,
      stroke,
      'stroke-width': 3,
      'stroke-opacity': 0.5,
    }),
  );
}

/** Rings around times with warnings, and a stop sign behind a curve that ends before the last case. */
function marksOf({ points, end }: Curve, stroke: string, { x, y }: Place, isList: boolean): string[] {
  const rings = points
    .filter(({ row }) => row.warnings.length > 0)
    .map(({ value, median }) =>
      tag('circle', { cx: x(value), cy: y(median), r: 7.5, fill: 'none', stroke, 'stroke-dasharray': '2 2' }),
    );
  if (end === null || isList) return rings;
  const { value, median } = points.at(-1)!;
  const style = { fill: stroke, 'font-size': 15, 'font-weight': 'bold', dy: '0.32em' };
  return [...rings, textTag('⊣', { x: x(value) + 11, y: y(median), ...style })];
}

/** Names of competitors beside the ends of their lines, moved apart so that none overlap. */
function endLabels(
  named: readonly Curve[],
  curves: readonly Curve[],
  place: Place,
  area: { width: number; height: number; right: number; top: number; bottom: number },
  paint: DrawOptions['paint'],
): string[] {
  const ends = named.map(({ points }) => ({ x: place.x(points.at(-1)!.value), y: place.y(points.at(-1)!.median) }));
  const rows = spreadLabels(
    ends.map(({ y }) => y),
    13,
    area.top - 12,
    area.height - area.bottom + 10,
  );
  const left = area.width - area.right + 20;
  return (rows ?? []).map((row, i) => {
    const { competitor, end } = named[i];
    const colour = paint.competitor(competitor);
    const from = ends[i].x + (end === null ? 6 : 18);
    const leader = `M${at(from, ends[i].y)}L${at(Math.max(from, left - 12), ends[i].y)}L${at(left - 3, row)}`;
    return tag(
      'g',
      { class: `group group-${curves.indexOf(named[i])}`, 'aria-hidden': 'true' },
      tag('path', { d: leader, fill: 'none', stroke: colour, 'stroke-opacity': 0.45 }),
      textTag(competitorWord(competitor), { x: left, y: row, dy: '0.32em', fill: colour, 'text-anchor': 'start' }),
    );
  });
}

/** Bounds of the times (ms) with a margin; a spread far from its median is cut off, or curves would look flat. */
function timeBounds(curves: readonly Curve[], kind: 'log' | 'linear'): { low: number; high: number } {
  const points = curves.flatMap((curve) => curve.points);
  const medians = points.map(({ median }) => median);
  const lowest = Math.max(Math.min(...points.map(({ low }) => low)), Math.min(...medians) / 3);
  const highest = Math.min(Math.max(...points.map(({ high }) => high)), Math.max(...medians) * 3);
  return kind === 'log' ? { low: lowest * 0.85, high: highest * 1.15 } : { low: 0, high: highest * 1.05 };
}

/** The scale of a series' values; a single value is in the middle. */
function valueScale(
  { axis }: LabSeries,
  values: readonly number[],
  kind: 'log' | 'linear',
  range: readonly [number, number],
): Scale {
  const [from, to] = [values[0], values.at(-1)!];
  if (isNamed(axis)) return scaleOf('linear', [from - 0.4, to + 0.4], range);
  const type = kind === 'linear' ? 'linear' : from > 0 ? 'log' : 'symlog';
  if (from < to) return scaleOf(type, [from, to], range);
  return type === 'log' ? scaleOf(type, [from / 2, to * 2], range) : scaleOf(type, [from - 1, to + 1], range);
}
