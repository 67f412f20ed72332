import { pagePaint } from './chartPaint';
import { competitorMark } from './competitorMarks';
import { isStroked, symbolPath } from './markSymbols';

/** A competitor's line and symbol, as in the charts. */
export function CompetitorSwatch({ name }: { name: string }) {
  const { symbol, hollow } = competitorMark(name);
  const colour = pagePaint.competitor(name);
  const fill = isStroked(symbol) ? 'none' : hollow ? pagePaint.background : colour;
  return (
    <svg class="chart-swatch" width="24" height="14" viewBox="-12 -7 24 14" aria-hidden="true">
      <path d="M-12,0H12" stroke={colour} stroke-width={name === 'auto' ? 2.6 : 1.8} />
      <path d={symbolPath(symbol, 4)} fill={fill} stroke={colour} stroke-width={hollow ? 1.7 : 1} />
    </svg>
  );
}
