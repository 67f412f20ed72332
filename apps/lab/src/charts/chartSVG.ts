import { verdictWords } from '../thesis/verdictWords';
import { competitorWord } from '../words/names';
import { type ChartPaint, paintOf } from './chartPaint';
import type { ChartSpec } from './ChartSpec';
import { competitorMark } from './competitorMarks';
import { isStroked, symbolPath } from './markSymbols';
import { runDashes } from './plotMarks';
import { SvgDocument, type SvgNode } from './SvgDocument';
import { textWidth } from './svgElement';
import { wrapText } from './wrapText';

export interface ChartFileOptions {
  /** Width in pixels, 320 at least; 960 by default. */
  readonly width?: number;
  /** Default: light. */
  readonly theme?: 'light' | 'dark';
  /** Where the figures come from, in small type at the end: device, browser, date. */
  readonly source?: string;
}

const PAD = 24;

/**
 * A chart as an SVG file that stands by itself: with its colours, title, legend and sentences, set in the reader's own
 * fonts. Needs no browser.
 */
export function chartSVG(
  chart: ChartSpec,
  { width = 960, theme = 'light', source = '' }: ChartFileOptions = {},
): string {
  const paint = paintOf(theme);
  const document = new SvgDocument();
  const room = width - 2 * PAD;
  const page = new SvgPage(document, paint, room);
  page.text(chart.title, 19, paint.text, 'bold');
  if (chart.choice) page.text(chart.choice.options[chart.choice.selected], 14, paint.dim);
  page.space(8);
  page.drawing(chart.draw({ width: room, paint, document: document as unknown as Document }).svg as unknown as SvgNode);
  page.space(6);
  page.row([
    ...chart.legend.map((name) => ({ words: competitorWord(name), mark: markOf(document, name, paint), width: 26 })),
    ...chart.keys.map(({ label, colour }) => ({
      ...{ words: label, width: 18 },
      mark: [node(document, 'rect', { x: 0, y: -6, width: 12, height: 12, rx: 2, fill: colour(paint) })],
    })),
    ...chart.runs.map((words, i) => ({
      ...{ words, width: 36 },
      mark: [
        node(document, 'path', {
          ...{ d: 'M0,0H30', stroke: paint.text, 'stroke-width': 2 },
          'stroke-dasharray': runDashes[i % runDashes.length] ?? 'none',
        }),
      ],
    })),
  ]);
  page.space(4);
  for (const sentence of chart.sentences) page.text(sentence, 14, paint.text);
  for (const verdict of chart.verdicts) page.text(verdictWords(verdict), 13, paint.text);
  for (const note of chart.notes) page.text(note, 12, paint.dim);
  if (source !== '') page.text(source, 12, paint.dim);
  const { height, nodes } = page;
  const svg = node(document, 'svg', {
    ...{
      xmlns: 'http://www.w3.org/2000/svg',
      viewBox: `0 0 ${width} ${height + 2 * PAD}`,
      width,
      height: height + 2 * PAD,
    },
    ...{ role: 'img', 'font-family': 'system-ui, sans-serif', 'aria-labelledby': 'title description' },
  });
  const titled = [node(document, 'title', { id: 'title' }, chart.title)];
  titled.push(node(document, 'desc', { id: 'description' }, [chart.description, ...chart.sentences].join(' ')));
  const back = node(document, 'rect', { width: '100%', height: '100%', fill: paint.background });
  const body = node(document, 'g', { transform: `translate(${PAD},${PAD})` });
  body.append(...nodes);
  svg.append(...titled, back, body);
  return `${svg.outerHTML}\n`;
}

/** Things one below the other. */
class SvgPage {
  readonly nodes: SvgNode[] = [];
  height = 0;

  constructor(
    private readonly document: SvgDocument,
    private readonly paint: ChartPaint,
    private readonly room: number,
  ) {}

  space(pixels: number): void {
    this.height += pixels;
  }

  text(text: string, size: number, fill: string, weight = 'normal'): void {
    for (const line of wrapText(text, this.room, size)) {
      this.height += Math.round(size * 1.4);
      const attributes = {
        x: 0,
        y: this.height - Math.round(size * 0.4),
        fill,
        'font-size': size,
        'font-weight': weight,
      };
      this.nodes.push(node(this.document, 'text', attributes, line));
    }
    this.height += 4;
  }

  /** What a chart drew, without the styles that it has for a page. */
  drawing(svg: SvgNode): void {
    const group = node(this.document, 'g', {
      ...{ transform: `translate(0,${this.height})`, color: this.paint.text, fill: 'currentColor', 'font-size': 12 },
      'text-anchor': svg.getAttribute('text-anchor') ?? 'middle',
    });
    group.append(...svg.children.filter((child) => typeof child !== 'string' && child.tagName !== 'style'));
    this.nodes.push(group);
    this.height += Number(svg.getAttribute('height'));
  }

  /** Marks with words, in as many lines as they take. */
  row(items: readonly { words: string; mark: readonly SvgNode[]; width: number }[]): void {
    if (items.length === 0) return;
    let x = 0;
    this.height += 20;
    for (const { words, mark, width } of items) {
      const whole = width + textWidth(words, 13) + 18;
      if (x > 0 && x + whole > this.room) {
        x = 0;
        this.height += 20;
      }
      const item = node(this.document, 'g', { transform: `translate(${x},${this.height - 8})` });
      item.append(
        ...mark,
        node(this.document, 'text', { x: width, y: 4.5, fill: this.paint.text, 'font-size': 13 }, words),
      );
      this.nodes.push(item);
      x += whole;
    }
    this.height += 6;
  }
}

function markOf(document: SvgDocument, name: string, paint: ChartPaint): SvgNode[] {
  const { symbol, hollow } = competitorMark(name);
  const stroke = paint.competitor(name);
  const fill = isStroked(symbol) ? 'none' : hollow ? paint.background : stroke;
  return [
    node(document, 'path', { d: 'M0,0H20', stroke, 'stroke-width': 1.8 }),
    node(document, 'path', {
      d: symbolPath(symbol, 4),
      transform: 'translate(10,0)',
      fill,
      stroke,
      'stroke-width': 1.5,
    }),
  ];
}

function node(
  document: SvgDocument,
  name: string,
  attributes: Readonly<Record<string, unknown>>,
  text?: string,
): SvgNode {
  const made = document.createElementNS('', name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (text !== undefined) made.textContent = text;
  return made;
}
