import type { Metric } from '../results/LabRun';
import type { Conclusion } from '../thesis/conclusions';
import type { ChartPaint } from './chartPaint';

/** What the user chose for all charts. */
export interface ChartSettings {
  readonly metric: Metric;
  /** Axes of times and of values. */
  readonly scale: 'log' | 'linear';
  /** Keys of competitors that are not shown. */
  readonly hidden: ReadonlySet<string>;
  /** Case shown by charts of one case, by key of the chart. */
  readonly cases: Readonly<Record<string, number>>;
}

/** Settings to begin with. */
export const defaultSettings: ChartSettings = { metric: 'frame', scale: 'log', hidden: new Set(), cases: {} };

/** What is told of one point, bar or cell. */
export interface ChartTip {
  readonly title: string;
  readonly lines: readonly string[];
}

/** A point, bar or cell that can be pointed at; x and y in pixels of the chart. */
export interface ChartPoint {
  readonly x: number;
  readonly y: number;
  /** Points of a group lie one after the other for the arrow keys: a line, a row of bars. */
  readonly group: string;
  /** Place within the group; the same in other groups for what stands beside it. */
  readonly order: number;
  readonly tip: ChartTip;
}

/** A chart as drawn at one width. */
export interface DrawnChart {
  readonly svg: SVGSVGElement;
  readonly points: readonly ChartPoint[];
}

export interface DrawOptions {
  /** Width in CSS pixels, 240 at least. */
  readonly width: number;
  readonly paint: ChartPaint;
  /** Makes the elements; the page's own document by default. */
  readonly document?: Document;
}

/** Figures of a chart as a table: text alone. */
export interface ChartTable {
  readonly columns: readonly string[];
  readonly rows: readonly (readonly string[])[];
}

/** One chart: its words and figures, and how it is drawn. */
export interface ChartSpec {
  /** Unique among the charts of a run, lower-kebab: also the name of its file. */
  readonly key: string;
  readonly title: string;
  /** What is drawn and along which axes, for those who do not see it. */
  readonly description: string;
  /** What the figures say. */
  readonly sentences: readonly string[];
  /** Conclusions that the figures bear out or not. */
  readonly verdicts: readonly Conclusion[];
  /** What is missing, and why: shown smaller. */
  readonly notes: readonly string[];
  readonly table: ChartTable;
  /** Keys of the competitors that are drawn with their marks. */
  readonly legend: readonly string[];
  /** Colours that mean something else than a competitor. */
  readonly keys: readonly { readonly label: string; readonly colour: (paint: ChartPaint) => string }[];
  /** Names of the runs by kind of line, where there are several. */
  readonly runs: readonly string[];
  /** Choice of a case, where the chart shows one of several. */
  readonly choice: { readonly label: string; readonly options: readonly string[]; readonly selected: number } | null;
  /** Takes as much width as there is, rather than a column. */
  readonly wide: boolean;
  draw(options: DrawOptions): DrawnChart;
}
