import { axisX } from './axes';
import type { ChartPaint } from './chartPaint';
import type { ChartPoint, ChartTip, DrawnChart, DrawOptions } from './ChartSpec';
import { competitorSymbol } from './competitorSymbol';
import { linearTicks, logTicks, scaleOf } from './scales';
import { fittedText, tag, textTag, textWidth } from './svg';

/** A bar of a row: it extends along the axis from one value to another. */
export interface RowBar {
  readonly from: number;
  readonly to: number;
  readonly fill: (paint: ChartPaint) => string;
  /** Opacity, 0 to 1; less than 1 for backgrounds and spreads. Default 1. */
  readonly opacity?: number;
  /** Index of the lane within the row, from the top. */
  readonly lane: number;
  readonly tip: ChartTip;
  /** Text after the bar's end; `shortText` replaces it in charts narrower than 520 pixels. */
  readonly text?: string;
  readonly shortText?: string;
}

/** A competitor's symbol in a row. */
export interface RowMark {
  readonly value: number;
  readonly competitor: string;
  readonly lane: number;
  readonly tip: ChartTip;
}

/** A row of a chart: bars and symbols along the axis; a row without measured values has no bars and no symbols. */
export interface ChartRow {
  readonly label: string;
  /** Whether the row is the title of the rows below. */
  readonly isHeading?: boolean;
  /** Competitor whose symbol stands before the label. */
  readonly competitor?: string;
  readonly bars: readonly RowBar[];
  readonly marks?: readonly RowMark[];
  /** Values of thin lines across the row. */
  readonly ticks?: readonly number[];
}

export interface RowsChart {
  readonly rows: readonly ChartRow[];
  /** Number of bars in a row, one below the other. */
  readonly lanes: number;
  readonly type: 'log' | 'linear';
  readonly domain: readonly [number, number];
  /** Returns the values of at most `most` ticks; round ones by default. */
  readonly ticks?: (most: number) => readonly number[];
  readonly label: string;
  readonly format: (value: number) => string;
  /** Values of dashed lines across all rows. */
  readonly rules?: readonly number[];
}

/** Draws rows of bars and symbols, with labels on the left. */
export function drawRows(chart: RowsChart, { width, paint }: DrawOptions): DrawnChart {
  const { rows, lanes, type, domain, label, format } = chart;
  const lane = lanes === 1 ? 15 : 10;
  const rowHeight = lanes * lane + 9;
  const isNarrow = width < 520;
  const textOf = (bar: RowBar): string => (isNarrow ? (bar.shortText ?? bar.text) : bar.text) ?? '';
  const widest = Math.max(...rows.map((row) => (row.isHeading ? 0 : textWidth(row.label) + (row.competitor ? 18 : 0))));
  const ends = rows.flatMap(({ bars }) => bars.map((bar) => (textOf(bar) ? textWidth(textOf(bar), 11) + 10 : 0)));
  const area = {
    ...{ width, height: 6 + rows.length * rowHeight + 42, top: 6, bottom: 42 },
    left: Math.round(Math.min(widest + 14, width * 0.44)),
    right: Math.round(Math.min(Math.max(18, ...ends), width * 0.34)),
  };
  const x = scaleOf(type, domain, [area.left, width - area.right]);
  const middle = (row: number, index: number): number => area.top + row * rowHeight + 4 + (index + 0.5) * lane;
  const count = Math.max(2, Math.floor((width - area.left - area.right) / 64));
  const ticks =
    chart.ticks?.(isNarrow ? 5 : 9) ??
    (type === 'log' ? logTicks(...domain, isNarrow ? 4 : 8) : linearTicks(...domain, count));
  const line = (value: number, from: number, to: number, attributes: Record<string, string | number>): string =>
    tag('path', { d: `M${x(value).toFixed(2)},${from}V${to}`, ...attributes });

  const drawn = rows.map((row, i) =>
    tag(
      'g',
      { class: `group group-${i}`, 'aria-hidden': 'true' },
      ...row.bars.flatMap((bar) => [
        tag('rect', {
          ...{ x: x(bar.from), y: middle(i, bar.lane) - lane / 2 + 1, height: lane - 2 },
          width: Math.max(0, x(bar.to) - x(bar.from) - 0.5),
          ...{ fill: bar.fill(paint), 'fill-opacity': bar.opacity ?? 1 },
        }),
        textTag(textOf(bar), {
          ...{ x: x(bar.to) + 5, y: middle(i, bar.lane), dy: '0.32em', 'text-anchor': 'start' },
          ...{ fill: paint.text, 'font-size': 11 },
        }),
      ]),
      ...(row.ticks ?? []).map((value) =>
        line(value, middle(i, 0) - lane / 2 - 1, middle(i, lanes - 1) + lane / 2 + 1, {
          ...{ stroke: paint.text, 'stroke-width': 1.5 },
        }),
      ),
      ...(row.marks ?? []).map((mark) =>
        competitorSymbol(mark.competitor, x(mark.value), middle(i, mark.lane), 4.5, paint),
      ),
    ),
  );
  const svg = [
    axisX({ ticks, scale: x, format, label: `${label} →` }, area, paint),
    ...(chart.rules ?? []).map((value) =>
      line(value, area.top, area.height - area.bottom, { stroke: paint.dim, 'stroke-dasharray': '3 3' }),
    ),
    ...drawn,
    ...rows.map((row, i) => labelOf(row, middle(i, (lanes - 1) / 2), area.left, paint)),
  ].join('');
  const points = rows.flatMap((row, i): ChartPoint[] => [
    ...row.bars.map((bar, k) => ({
      ...{ x: (x(bar.from) + x(bar.to)) / 2, y: middle(i, bar.lane), group: String(i), order: k, tip: bar.tip },
    })),
    ...(row.marks ?? []).map((mark, k) => ({
      ...{ x: x(mark.value), y: middle(i, mark.lane), group: String(i), order: row.bars.length + k, tip: mark.tip },
    })),
  ]);
  return { height: area.height, svg, points };
}

/** A row's label, shortened to fit, after the competitor's symbol. */
function labelOf(
  { label, isHeading = false, competitor }: ChartRow,
  y: number,
  room: number,
  paint: ChartPaint,
): string {
  const left = competitor === undefined ? 2 : 18;
  const words = textTag(isHeading ? label : fittedText(label, room - left - 6), {
    ...{ x: left, y, dy: '0.32em', fill: paint.text, 'text-anchor': 'start' },
    'font-weight': isHeading ? 'bold' : undefined,
  });
  return competitor === undefined ? words : competitorSymbol(competitor, 7, y, 4.5, paint) + words;
}
