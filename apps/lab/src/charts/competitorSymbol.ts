import type { ChartPaint } from './chartPaint';
import { competitorMark } from './competitorMarks';
import { tag } from './svg';

/** A symbol of unit radius as polylines: [x, y, x, y, …] each; closed unless it is made of strokes. */
interface MarkSymbol {
  readonly lines: readonly (readonly number[])[];
  readonly closed: boolean;
}

const turn = Math.PI * 2;
/** Corners on a circle, or alternately on circles of several radii. */
const corners = (count: number, start: number, radii: readonly number[]): number[] =>
  Array.from({ length: count }, (_, i) => {
    const angle = start + (i / count) * turn;
    const radius = radii[i % radii.length];
    return [radius * Math.cos(angle), radius * Math.sin(angle)];
  }).flat();
const shape = (...points: number[]): MarkSymbol => ({ lines: [points], closed: true });
const strokes = (...lines: number[][]): MarkSymbol => ({ lines, closed: false });
const a = 0.34;

const symbols = {
  circle: shape(...corners(24, 0, [0.95])),
  square: shape(-0.85, -0.85, 0.85, -0.85, 0.85, 0.85, -0.85, 0.85),
  diamond: shape(...corners(4, 0, [1.2])),
  triangle: shape(...corners(3, -turn / 4, [1.25])),
  hexagon: shape(...corners(6, 0, [1.1])),
  star: shape(...corners(10, -turn / 4, [1.4, 0.6])),
  cross: shape(-a, -1.1, a, -1.1, a, -a, 1.1, -a, 1.1, a, a, a, a, 1.1, -a, 1.1, -a, a, -1.1, a, -1.1, -a, -a, -a),
  wye: shape(...corners(3, turn / 4, [1.25])),
  times: strokes([-0.85, -0.85, 0.85, 0.85], [-0.85, 0.85, 0.85, -0.85]),
  plus: strokes([-1.1, 0, 1.1, 0], [0, -1.1, 0, 1.1]),
  asterisk: strokes(...[0, 1, 2].map((i) => corners(2, turn / 4 + (i * turn) / 6, [1.15]))),
} satisfies Record<string, MarkSymbol>;

/** Name of a symbol: `wye` is a triangle that points down. */
export type MarkSymbolName = keyof typeof symbols;

/** Path data of a symbol around the origin. */
function symbolPath(name: MarkSymbolName, radius: number): string {
  const { lines, closed } = symbols[name];
  const round = (value: number): number => Math.round(value * radius * 100) / 100;
  return lines
    .map((line) => {
      const places: string[] = [];
      for (let i = 0; i < line.length; i += 2) places.push(`${round(line[i])},${round(line[i + 1])}`);
      return `M${places.join('L')}${closed ? 'Z' : ''}`;
    })
    .join('');
}

/** A competitor's symbol as SVG text, its middle at x, y (pixels). */
export function competitorSymbol(competitor: string, x: number, y: number, radius: number, paint: ChartPaint): string {
  const { symbol, hollow } = competitorMark(competitor);
  const { closed } = symbols[symbol];
  const stroke = paint.competitor(competitor);
  return tag('path', {
    ...{ d: symbolPath(symbol, radius), transform: `translate(${x.toFixed(2)},${y.toFixed(2)})`, stroke },
    fill: !closed ? 'none' : hollow ? paint.background : stroke,
    'stroke-width': hollow || !closed ? 1.7 : 1,
  });
}
