import { axisX, gridX, type Markish, plot, rect, ruleX, scale, text } from '@observablehq/plot';
import type { ChartPaint } from './chartPaint';
import type { ChartPoint, ChartTip, DrawnChart, DrawOptions } from './ChartSpec';
import { competitorMark } from './competitorMarks';
import { isStroked, symbolPath } from './markSymbols';
import { competitorDots, plotStyle } from './plotMarks';
import { fittedText, svgElement, textWidth } from './svgElement';

/** A bar of a row, from value to value. */
export interface RowBar {
  readonly from: number;
  readonly to: number;
  readonly fill: (paint: ChartPaint) => string;
  /** Less than 1 for what is background or unsure; 1 by default. */
  readonly opacity?: number;
  /** Which of the row's lanes, from the top. */
  readonly lane: number;
  readonly tip: ChartTip;
  /** Text behind the bar's end, and what stands there where the chart is narrow. */
  readonly text?: string;
  readonly shortText?: string;
}

/** A competitor's symbol in a row. */
export interface RowMark {
  readonly at: number;
  readonly competitor: string;
  readonly lane: number;
  readonly tip: ChartTip;
}

/** A row of a chart: bars and symbols along the axis, or none where there are no data. */
export interface ChartRow {
  readonly label: string;
  /** Whether it is the title of the rows below it. */
  readonly isHeading?: boolean;
  /** Whose symbol stands before the label. */
  readonly competitor?: string;
  readonly bars: readonly RowBar[];
  readonly marks?: readonly RowMark[];
  /** Places of thin lines across the row. */
  readonly ticks?: readonly number[];
}

/** Rows along one axis. */
export interface RowsChart {
  readonly rows: readonly ChartRow[];
  /** Bars one below the other in a row. */
  readonly lanes: number;
  readonly type: 'log' | 'linear';
  readonly domain: readonly [number, number];
  /** Places of ticks; round ones by default. */
  readonly ticks?: readonly number[];
  readonly label: string;
  readonly format: (value: number) => string;
  /** Places of lines across all rows. */
  readonly rules?: readonly number[];
}

const TOP = 6;
const BOTTOM = 42;

/** Draws rows of bars and symbols, their labels on the left. */
export function drawRows(chart: RowsChart, { width, paint, document = globalThis.document }: DrawOptions): DrawnChart {
  const { rows, lanes, type } = chart;
  const lane = lanes === 1 ? 15 : 10;
  const rowHeight = lanes * lane + 9;
  const height = TOP + rows.length * rowHeight + BOTTOM;
  const widest = Math.max(
    ...rows.map(({ label, isHeading, competitor }) => (isHeading ? 0 : textWidth(label) + (competitor ? 18 : 0))),
  );
  const marginLeft = Math.round(Math.min(widest + 14, width * 0.44));
  const textOf = (bar: RowBar): string => (width < 520 ? (bar.shortText ?? bar.text) : bar.text) ?? '';
  const ends = rows.flatMap(({ bars }) => bars.map((bar) => (textOf(bar) ? textWidth(textOf(bar), 11) + 10 : 0)));
  const marginRight = Math.round(Math.min(Math.max(18, ...ends), width * 0.34));
  const x = { type, domain: [...chart.domain], range: [marginLeft, width - marginRight] };
  const y = { type: 'linear', domain: [0, height], range: [0, height], axis: null };
  const place = scale({ x } as Parameters<typeof scale>[0]);
  const at = (value: number): number => place.apply(value) as number;
  const middle = (row: number, of: number): number => TOP + row * rowHeight + 4 + (of + 0.5) * lane;

  const ticks = chart.ticks ? [...chart.ticks] : undefined;
  const count = ticks ?? Math.max(2, Math.floor((width - marginLeft - marginRight) / 64));
  const marks: Markish[] = [
    gridX({ ticks: count, stroke: paint.grid, strokeOpacity: 1 }),
    axisX({
      ticks: count,
      color: paint.dim,
      fontSize: 12,
      tickSize: 4,
      label: `${chart.label} →`,
      text: (value: number) => chart.format(value),
    }),
    ...(chart.rules ?? []).map((rule) => ruleX([rule], { stroke: paint.dim, strokeDasharray: '3 3' })),
  ];
  rows.forEach((row, i) => {
    const own = { className: `group group-${i}`, ariaHidden: 'true' };
    marks.push(
      rect(row.bars as RowBar[], {
        ...own,
        ...{ x1: 'from', x2: 'to' },
        y1: (bar: RowBar) => middle(i, bar.lane) - lane / 2 + 1,
        y2: (bar: RowBar) => middle(i, bar.lane) + lane / 2 - 1,
        fill: (bar: RowBar) => bar.fill(paint),
        fillOpacity: (bar: RowBar) => bar.opacity ?? 1,
        insetRight: 0.5,
      }),
      text(
        row.bars.filter((bar) => textOf(bar)),
        {
          ...own,
          ...{ x: 'to', y: (bar: RowBar) => middle(i, bar.lane), text: textOf, textAnchor: 'start', dx: 5 },
          ...{ fill: paint.text, fontSize: 11 },
        },
      ),
      ruleX(row.ticks ?? [], {
        ...own,
        ...{
          y1: middle(i, 0) - lane / 2 - 1,
          y2: middle(i, lanes - 1) + lane / 2 + 1,
          stroke: paint.text,
          strokeWidth: 1.5,
        },
      }),
    );
    for (const mark of row.marks ?? []) {
      const where = { x: () => mark.at, y: () => middle(i, mark.lane), className: own.className, r: 4.5 };
      marks.push(competitorDots([mark], mark.competitor, paint, where));
    }
  });
  const svg = plot({
    ...{ width, height, document, marginLeft, marginRight, marginTop: TOP, marginBottom: BOTTOM, marks },
    ...{ x, y, color: { type: 'identity' }, opacity: { type: 'identity' }, style: { ...plotStyle, color: paint.text } },
  } as Parameters<typeof plot>[0]) as SVGSVGElement;
  rows.forEach((row, i) => svg.append(...labelOf(row, middle(i, (lanes - 1) / 2), marginLeft, paint, document)));

  const points = rows.flatMap((row, i): ChartPoint[] => [
    ...row.bars.map((bar, k) => ({
      ...{ x: (at(bar.from) + at(bar.to)) / 2, y: middle(i, bar.lane), group: String(i), order: k, tip: bar.tip },
    })),
    ...(row.marks ?? []).map((mark, k) => ({
      ...{ x: at(mark.at), y: middle(i, mark.lane), group: String(i), order: row.bars.length + k, tip: mark.tip },
    })),
  ]);
  return { svg, points };
}

/** A row's label, cut where it is longer than its place, with the competitor's symbol before it. */
function labelOf(
  { label, isHeading = false, competitor }: ChartRow,
  y: number,
  room: number,
  paint: ChartPaint,
  document: Document,
): SVGElement[] {
  const left = competitor === undefined ? 2 : 18;
  const shown = isHeading ? label : fittedText(label, room - left - 6);
  const style = { 'font-size': 12, 'text-anchor': 'start', 'font-weight': isHeading ? 'bold' : 'normal' };
  const words = svgElement(document, 'text', { x: left, y, dy: '0.32em', fill: paint.text, ...style }, shown);
  if (competitor === undefined) return [words];
  const { symbol, hollow } = competitorMark(competitor);
  const colour = paint.competitor(competitor);
  return [
    svgElement(document, 'path', {
      ...{ d: symbolPath(symbol, 4.5), transform: `translate(7,${y})`, stroke: colour },
      fill: isStroked(symbol) ? 'none' : hollow ? paint.background : colour,
      'stroke-width': hollow || isStroked(symbol) ? 1.7 : 1,
    }),
    words,
  ];
}
