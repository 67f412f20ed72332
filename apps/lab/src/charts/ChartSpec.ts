import type { Metric } from '../results/LabRun';
import type { ChartPaint } from './chartPaint';

/** Settings that hold for all charts of the page. */
export interface ChartSettings {
  readonly metric: Metric;
  /** Type of the axes for times and for the series' values. */
  readonly scale: 'log' | 'linear';
  /** Keys of competitors that are left out. */
  readonly hidden: ReadonlySet<string>;
  /** Index of the chosen option, by key of a chart with a choice. */
  readonly cases: Readonly<Record<string, number>>;
}

export const defaultSettings: ChartSettings = { metric: 'frame', scale: 'log', hidden: new Set(), cases: {} };

/** Text of the note at a point, bar or cell. */
export interface ChartTip {
  readonly title: string;
  readonly lines: readonly string[];
}

/** A point, bar or cell with a note; x and y in pixels of the chart. */
export interface ChartPoint {
  readonly x: number;
  readonly y: number;
  /** Line or row within which the left and right arrow keys move. */
  readonly group: string;
  /** Index within the group; up and down arrow keys move between points of equal order. */
  readonly order: number;
  readonly tip: ChartTip;
}

/** A chart as drawn at one width. */
export interface DrawnChart {
  /** Height of the drawing (pixels). */
  readonly height: number;
  /** Elements as SVG text, without the `<svg>` around them: texts are centred and of 12 pixels by default. */
  readonly svg: string;
  readonly points: readonly ChartPoint[];
}

export interface DrawOptions {
  /** Width of the drawing in CSS pixels, 240 at least. */
  readonly width: number;
  readonly paint: ChartPaint;
}

export interface ChartTable {
  readonly columns: readonly string[];
  readonly rows: readonly (readonly string[])[];
}

/** A choice of one of several cases or renderers. */
export interface ChartChoice {
  readonly label: string;
  readonly options: readonly string[];
  /** Index of the chosen option. */
  readonly selected: number;
  /** Whether an export has a file for each option; otherwise one for the chosen option. */
  readonly exportsAll?: boolean;
}

/** One chart: its texts, its table of values, and the function that draws it. */
export interface ChartSpec {
  /** Unique key among the charts of a run, lower-kebab; also the name of its file. */
  readonly key: string;
  readonly title: string;
  /** Contents and axes of the drawing in words, for screen readers. */
  readonly description: string;
  /** Texts in small type below the drawing: a legend in words, and reasons why values are missing. */
  readonly notes?: readonly string[];
  readonly table: ChartTable;
  /** Keys of the competitors whose marks are explained in the legend of a saved file. */
  readonly legend?: readonly string[];
  /** Legend of colours that do not stand for competitors. */
  readonly keys?: readonly { readonly label: string; readonly colour: (paint: ChartPaint) => string }[];
  /** Names of the runs, in the order of their line styles, when there are several. */
  readonly runs?: readonly string[];
  readonly choice?: ChartChoice | null;
  draw(options: DrawOptions): DrawnChart;
}
