import { competitorWord } from '../words/names';
import { type ChartPaint, paintOf, runDashes } from './chartPaint';
import type { ChartSpec } from './ChartSpec';
import { competitorSymbol } from './competitorSymbol';
import { tag, textTag, textWidth, wrapText } from './svg';

export interface ChartFileOptions {
  /** Width in pixels, 320 at least; 960 by default. */
  readonly width?: number;
  /** Theme of the file; light by default. */
  readonly theme?: 'light' | 'dark';
  /** Origin of the measurements (device, browser, date), written in small type at the end of the file. */
  readonly source?: string;
}

/** One entry of the legend: a mark, and the text beside it. */
interface LegendItem {
  readonly words: string;
  readonly mark: string;
  /** Distance from the mark's left edge to the text (pixels). */
  readonly indent: number;
}

const PAD = 24;

/** A chart as an SVG file with its colours, title, legend and notes, in the system's fonts. Needs no browser. */
export function chartSVG(
  chart: ChartSpec,
  { width = 960, theme = 'light', source = '' }: ChartFileOptions = {},
): string {
  const paint = paintOf(theme);
  const room = width - 2 * PAD;
  const { choice, notes = [] } = chart;
  const parts: string[] = [];
  let height = 0;
  const write = (words: string, size: number, fill: string, weight?: string): void => {
    for (const line of wrapText(words, room, size)) {
      height += Math.round(size * 1.4);
      const y = height - Math.round(size * 0.4);
      parts.push(textTag(line, { x: 0, y, fill, 'font-size': size, 'font-weight': weight }));
    }
    height += 4;
  };
  write(chart.title, 19, paint.text, 'bold');
  if (choice) write(choice.options[choice.selected], 14, paint.dim);
  height += 8;
  const drawn = chart.draw({ width: room, paint });
  const centred = { 'font-size': 12, 'text-anchor': 'middle', fill: paint.text };
  parts.push(tag('g', { transform: `translate(0,${height})`, ...centred }, drawn.svg));
  height += drawn.height + 6;
  let x = 0;
  const items = legendOf(chart, paint);
  if (items.length > 0) height += 20;
  for (const { words, mark, indent } of items) {
    const whole = indent + textWidth(words, 13) + 18;
    if (x > 0 && x + whole > room) {
      x = 0;
      height += 20;
    }
    const text = textTag(words, { x: indent, y: 4.5, fill: paint.text, 'font-size': 13 });
    parts.push(tag('g', { transform: `translate(${x},${height - 8})` }, mark, text));
    x += whole;
  }
  height += 10;
  for (const note of [...notes, source].filter(Boolean)) write(note, 12, paint.dim);
  height += 2 * PAD;
  return `${tag(
    'svg',
    {
      ...{ xmlns: 'http://www.w3.org/2000/svg', viewBox: `0 0 ${width} ${height}`, width, height },
      ...{ role: 'img', 'font-family': 'system-ui, sans-serif', 'aria-labelledby': 'title description' },
    },
    textTag(chart.title, { id: 'title' }, 'title'),
    textTag(chart.description, { id: 'description' }, 'desc'),
    tag('rect', { width: '100%', height: '100%', fill: paint.background }),
    tag('g', { transform: `translate(${PAD},${PAD})` }, ...parts),
  )}\n`;
}

function legendOf({ legend = [], keys = [], runs = [] }: ChartSpec, paint: ChartPaint): LegendItem[] {
  const line = (length: number, stroke: string, dashes?: string): string =>
    tag('path', { d: `M0,0H${length}`, stroke, 'stroke-width': 1.8, 'stroke-dasharray': dashes });
  return [
    ...legend.map((name) => ({
      ...{ words: competitorWord(name), indent: 26 },
      mark: line(20, paint.competitor(name)) + competitorSymbol(name, 10, 0, 4, paint),
    })),
    ...keys.map(({ label, colour }) => ({
      ...{ words: label, indent: 18 },
      mark: tag('rect', { x: 0, y: -6, width: 12, height: 12, rx: 2, fill: colour(paint) }),
    })),
    ...runs.map((words, i) => ({ words, indent: 36, mark: line(30, paint.text, runDashes[i % runDashes.length]) })),
  ];
}
