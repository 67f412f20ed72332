import type { ChartPaint } from './chartPaint';
import type { DrawnChart } from './ChartSpec';
import { svgElement } from './svgElement';

/** What stands in the place of a chart without figures. */
export function drawEmpty(width: number, paint: ChartPaint, document: Document): DrawnChart {
  const height = 80;
  const svg = svgElement(document, 'svg', { width, height, viewBox: `0 0 ${width} ${height}` }) as SVGSVGElement;
  const place = { x: width / 2, y: height / 2, 'text-anchor': 'middle', fill: paint.dim, 'font-size': 13 };
  svg.append(svgElement(document, 'text', place, 'No figures here'));
  return { svg, points: [] };
}
