import type { ChartPaint } from './chartPaint';
import type { Scale } from './scales';
import { tag, textTag } from './svg';

/** A chart's size and the margins around its plot (pixels). */
export interface PlotArea {
  readonly width: number;
  readonly height: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
  readonly left: number;
}

interface Axis {
  readonly ticks: readonly number[];
  readonly scale: Scale;
  readonly format: (value: number) => string;
  readonly label: string;
}

const TICK = 4;

/** Grid lines, ticks, their texts and the label of an axis along the bottom. */
export function axisX({ ticks, scale, format, label }: Axis, area: PlotArea, paint: ChartPaint): string {
  const bottom = area.height - area.bottom;
  const lines = ticks.flatMap((value) => {
    const x = scale(value);
    return [
      tag('path', { d: `M${x.toFixed(2)},${area.top}V${bottom}`, stroke: paint.grid }),
      tag('path', { d: `M${x.toFixed(2)},${bottom}v${TICK}`, stroke: paint.dim }),
      textTag(format(value), { x, y: bottom + TICK + 3, dy: '0.71em', fill: paint.dim }),
    ];
  });
  const place = { x: area.width - 3, y: area.height - 3, fill: paint.dim, 'text-anchor': 'end' };
  return tag('g', { 'aria-hidden': 'true' }, ...lines, textTag(label, place));
}

/** Grid lines, ticks, their texts and the label of an axis along the left. */
export function axisY({ ticks, scale, format, label }: Axis, area: PlotArea, paint: ChartPaint): string {
  const right = area.width - area.right;
  const lines = ticks.flatMap((value) => {
    const y = scale(value);
    return [
      tag('path', { d: `M${area.left},${y.toFixed(2)}H${right}`, stroke: paint.grid }),
      tag('path', { d: `M${area.left},${y.toFixed(2)}h${-TICK}`, stroke: paint.dim }),
      textTag(format(value), { x: area.left - TICK - 3, y, dy: '0.32em', fill: paint.dim, 'text-anchor': 'end' }),
    ];
  });
  const place = { x: 3, y: 3, dy: '0.71em', fill: paint.dim, 'text-anchor': 'start' };
  return tag('g', { 'aria-hidden': 'true' }, ...lines, textTag(label, place));
}
