import { pagePaint } from './chartPaint';
import { competitorSymbol } from './competitorSymbol';
import { tag } from './svg';

/** A competitor's line and symbol, as in the charts. */
export function CompetitorSwatch({ name }: { name: string }) {
  const line = { d: 'M-12,0H12', stroke: pagePaint.competitor(name), 'stroke-width': name === 'auto' ? 2.6 : 1.8 };
  return (
    <svg
      class="chart-swatch"
      width="24"
      height="14"
      viewBox="-12 -7 24 14"
      aria-hidden="true"
      dangerouslySetInnerHTML={{ __html: tag('path', line) + competitorSymbol(name, 0, 0, 4, pagePaint) }}
    />
  );
}
