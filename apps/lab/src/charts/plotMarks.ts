import { dot, type Markish } from '@observablehq/plot';
import type { ChartPaint } from './chartPaint';
import { competitorMark } from './competitorMarks';
import { isStroked, plotSymbol } from './markSymbols';

/** Style of every chart's drawing: text as on the page, no background of its own. */
export const plotStyle = { background: 'none', fontFamily: 'inherit', fontSize: '12px', overflow: 'visible' };

/** Kinds of line by index of the run: the first whole, others dashed. */
export const runDashes: readonly (string | undefined)[] = [undefined, '7 4', '2 4', '10 3 2 3'];

/** Points with a competitor's symbol. */
export function competitorDots<T>(
  data: readonly T[],
  competitor: string,
  paint: ChartPaint,
  options: { x: (each: T) => number; y: (each: T) => number | string; className?: string; r?: number },
): Markish {
  const { symbol, hollow } = competitorMark(competitor);
  const colour = paint.competitor(competitor);
  const stroked = isStroked(symbol);
  return dot(data as T[], {
    r: 4,
    ...options,
    symbol: plotSymbol(symbol),
    fill: stroked ? 'none' : hollow ? paint.background : colour,
    stroke: colour,
    strokeWidth: hollow || stroked ? 1.7 : 1,
    ariaHidden: 'true',
  });
}
