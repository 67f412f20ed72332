import {
  areaY,
  axisX,
  axisY,
  dot,
  gridX,
  gridY,
  lineY,
  type Markish,
  plot,
  ruleX,
  scale,
  text,
} from '@observablehq/plot';
import { isNamed, type LabSeries } from '../plan/LabPlan';
import { axisLabel } from '../plan/sceneWords';
import { formatNumber } from '../words/format';
import { competitorWord, metricWords } from '../words/names';
import { logTicks, ticksWithRoom, valueTick } from './axisTicks';
import type { ChartPoint, ChartSettings, DrawnChart, DrawOptions } from './ChartSpec';
import type { Curve, CurvePoint } from './curveData';
import { drawEmpty } from './drawEmpty';
import { competitorDots, plotStyle, runDashes } from './plotMarks';
import { rowTip } from './rowTip';
import { spreadLabels } from './spreadLabels';
import { svgElement, textWidth } from './svgElement';

/** Curves with bands of spread; names stand beside the lines' ends where there is room. */
export function drawCurves(
  series: LabSeries,
  curves: readonly Curve[],
  runNames: readonly string[],
  { metric, scale: kind }: Pick<ChartSettings, 'metric' | 'scale'>,
  { width, paint, document = globalThis.document }: DrawOptions,
): DrawnChart {
  if (curves.length === 0) return drawEmpty(width, paint, document);
  const height = Math.round(Math.min(480, Math.max(280, width * 0.6)));
  const named = curves.filter(({ competitor }, i) => curves.findIndex((each) => each.competitor === competitor) === i);
  const words = named.map(({ competitor }) => competitorWord(competitor));
  const nameRoom = Math.max(0, ...words.map((word) => textWidth(word))) + 26;
  const margins = { marginTop: 26, marginBottom: 42, marginLeft: 52, marginRight: 18 };
  const labelled = width >= 520 && (named.length - 1) * 13 <= height - margins.marginTop - margins.marginBottom + 20;
  if (labelled) margins.marginRight = nameRoom;
  const bounds = timeBounds(curves, kind);
  const ticksY = kind === 'log' ? logTicks(bounds.low, bounds.high, Math.floor(height / 34)) : undefined;
  const texts = (ticksY ?? [bounds.high]).map((ms) => textWidth(formatNumber(ms)));
  margins.marginLeft = Math.max(40, Math.max(...texts) + 16);
  const axes = scalesOf(series, curves, kind, bounds, width, height, margins);
  const place = {
    x: scale({ x: axes.x } as Parameters<typeof scale>[0]),
    y: scale({ y: axes.y } as Parameters<typeof scale>[0]),
  };
  const x = (value: number): number => place.x.apply(value) as number;
  const y = (ms: number): number => place.y.apply(ms) as number;

  const values = valuesOf(series, curves);
  const ticksX = ticksWithRoom(values, x, 12 + Math.max(...values.map((value) => textWidth(valueTick(series, value)))));
  const { low } = bounds;

  const marks: Markish[] = [
    gridY({ ticks: ticksY, stroke: paint.grid, strokeOpacity: 1 }),
    gridX(ticksX, { stroke: paint.grid, strokeOpacity: 1 }),
    axisX(ticksX, {
      label: isNamed(series.axis) ? axisLabel(series) : `${axisLabel(series)} →`,
      text: (value: number) => valueTick(series, value),
      color: paint.dim,
      tickSize: 4,
      fontSize: 12,
    }),
    axisY({
      ticks: ticksY,
      label: `↑ ${metricWords[metric].label} (ms)`,
      text: (ms: number) => formatNumber(ms),
      color: paint.dim,
      tickSize: 4,
      fontSize: 12,
    }),
  ];
  const lines: Markish[] = [];
  curves.forEach((curve, i) => {
    const colour = paint.competitor(curve.competitor);
    const className = `group group-${i}`;
    if (isNamed(series.axis)) {
      // names have no order: nothing leads from one to the next
      lines.push(
        ruleX(curve.points, {
          ...{ x: 'value', y1: (p: CurvePoint) => atLeast(p.low, low), y2: 'high', stroke: colour, strokeOpacity: 0.5 },
          ...{ strokeWidth: 3, className, ariaHidden: 'true' },
        }),
      );
    }
    for (const piece of isNamed(series.axis) ? [] : curve.pieces) {
      marks.push(
        areaY(piece as CurvePoint[], {
          ...{ x: 'value', y1: (p: CurvePoint) => atLeast(p.low, low), y2: 'high', fill: colour, fillOpacity: 0.13 },
          ...{ className, ariaHidden: 'true' },
        }),
      );
      lines.push(
        lineY(piece as CurvePoint[], {
          ...{ x: 'value', y: 'median', stroke: colour, strokeWidth: curve.competitor === 'auto' ? 2.6 : 1.8 },
          ...{ strokeDasharray: runDashes[curve.run % runDashes.length], className, ariaHidden: 'true' },
        }),
      );
    }
    const at = { x: (p: CurvePoint) => p.value, y: (p: CurvePoint) => p.median, className };
    lines.push(competitorDots(curve.points, curve.competitor, paint, at));
    const doubtful = curve.points.filter(({ row }) => row.warnings.length > 0);
    const ring = { r: 7.5, stroke: colour, strokeDasharray: '2 2', fill: 'none', ariaHidden: 'true' };
    lines.push(dot(doubtful, { ...at, ...ring }));
    if (curve.end !== null && !isNamed(series.axis)) {
      lines.push(
        text(curve.points.slice(-1), {
          ...{ ...at, text: () => '⊣', dx: 11, fill: colour, fontSize: 15, fontWeight: 'bold', ariaHidden: 'true' },
        }),
      );
    }
  });
  const svg = plot({
    ...{ width, height, document, ...margins, marks: [...marks, ...lines] },
    ...{ x: axes.x, y: axes.y, style: { ...plotStyle, color: paint.text } },
  } as Parameters<typeof plot>[0]) as SVGSVGElement;

  if (labelled) {
    const ends = named.map((curve) => ({ x: x(curve.points.at(-1)!.value), y: y(curve.points.at(-1)!.median) }));
    const rows = spreadLabels(
      ends.map((end) => end.y),
      13,
      margins.marginTop - 12,
      height - margins.marginBottom + 10,
    );
    rows?.forEach((row, i) => {
      const curve = named[i];
      const colour = paint.competitor(curve.competitor);
      const left = width - margins.marginRight + 20;
      const group = svgElement(document, 'g', { class: `group group-${curves.indexOf(curve)}`, 'aria-hidden': 'true' });
      const from = ends[i].x + (curve.end === null ? 6 : 18);
      const path = `M${from},${ends[i].y}L${Math.max(from, left - 12)},${ends[i].y}L${left - 3},${row}`;
      group.append(
        svgElement(document, 'path', {
          ...{ d: path, fill: 'none', stroke: colour, 'stroke-width': 1, 'stroke-opacity': 0.45 },
        }),
        svgElement(
          document,
          'text',
          { x: left, y: row, dy: '0.32em', fill: colour, 'font-size': 12, 'text-anchor': 'start' },
          words[i],
        ),
      );
      svg.append(group);
    });
  }
  const points = curves.flatMap((curve, i) =>
    curve.points.map((point): ChartPoint => {
      const own = rowTip(point.row, curve.series, metric, runNames.length > 1 ? runNames[curve.run] : '');
      const last = point === curve.points.at(-1) && curve.end !== null;
      const tip = last ? { ...own, lines: [...own.lines, `Ends here: ${curve.end}`] } : own;
      return { x: x(point.value), y: y(point.median), group: String(i), order: point.index, tip };
    }),
  );
  return { svg, points };
}

/** Values of all runs, ascending. */
function valuesOf(series: LabSeries, curves: readonly Curve[]): number[] {
  const values = new Set([...series.values, ...curves.flatMap((curve) => curve.series.values)]);
  return [...values].sort((a, b) => a - b);
}

function atLeast(value: number, low: number): number {
  return Math.max(value, low);
}

/** Bounds of the times (ms), with some room around them. */
function timeBounds(curves: readonly Curve[], kind: 'log' | 'linear'): { low: number; high: number } {
  const points = curves.flatMap((curve) => curve.points);
  const medians = points.map(({ median }) => median);
  // a spread far below its median says little and would squeeze the rest
  const lowest = Math.max(Math.min(...points.map(({ low }) => low)), Math.min(...medians) / 3);
  const highest = Math.min(Math.max(...points.map(({ high }) => high)), Math.max(...medians) * 3);
  return kind === 'log' ? { low: lowest * 0.85, high: highest * 1.15 } : { low: 0, high: highest * 1.05 };
}

/** Scales of both axes, wide enough for one point alone. */
function scalesOf(
  series: LabSeries,
  curves: readonly Curve[],
  kind: 'log' | 'linear',
  { low, high }: { low: number; high: number },
  width: number,
  height: number,
  margins: { marginTop: number; marginBottom: number; marginLeft: number; marginRight: number },
) {
  const values = valuesOf(series, curves);
  const [from, to] = [values[0], values.at(-1)!];
  const single = from === to;
  const isList = isNamed(series.axis);
  const logarithmic = kind === 'log' && from > 0 && !isList;
  const type = logarithmic ? 'log' : kind === 'log' && !isList ? 'symlog' : 'linear';
  const domain = isList
    ? [from - 0.4, to + 0.4]
    : !single
      ? [from, to]
      : logarithmic
        ? [from / 2, to * 2]
        : [from - 1, to + 1];
  const x = { type, domain, range: [margins.marginLeft + 10, width - margins.marginRight - 6] };
  const y = {
    ...{ type: kind, domain: [low, high], clamp: true },
    range: [height - margins.marginBottom, margins.marginTop],
  };
  return { x: type === 'symlog' ? { ...x, constant: 1 } : x, y };
}
