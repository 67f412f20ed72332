import type { Curve, CurveField } from '@farol/engine/fields';

/** From the bottom to the top of the graph of a curve. */
export interface ValueRange {
  readonly low: number;
  readonly high: number;
}

const ROUND = [1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10];

/** The next round number that is at least this one, which is above 0. */
function roundUp(value: number): number {
  const unit = 10 ** Math.floor(Math.log10(value));
  return (ROUND.find((each) => each >= value / unit - 1e-9) ?? 10) * unit;
}

/** The range that shows all keys of a curve, some room above them, within the limits of the field. */
export function valueRange({ min = -Infinity, max = Infinity }: CurveField, curve: Curve): ValueRange {
  const values = curve.map(([, value]) => value);
  const most = Math.max(...values);
  const least = Math.min(...values);
  const high = most > 0 ? roundUp(most * 1.1) : least < 0 ? 0 : 1;
  const low = least < 0 ? -roundUp(-least * 1.1) : 0;
  return { low: Math.max(low, min), high: Math.min(high, max) };
}

/** Where a value is between bottom (0) and top (1). */
export const shareOf = ({ low, high }: ValueRange, value: number): number =>
  high > low ? Math.min(Math.max((value - low) / (high - low), 0), 1) : 0.5;

/** The value at a share of the way up, with as many digits as a pixel of the graph can tell apart. */
export function valueAtShare({ low, high }: ValueRange, share: number): number {
  const unit = 10 ** Math.floor(Math.log10((high - low) / 100));
  const value = Math.round((low + Math.min(Math.max(share, 0), 1) * (high - low)) / unit) * unit;
  return Math.min(Math.max(Number(value.toPrecision(12)), low), high);
}

/** The points of a curve in a box of 1 by 1 whose y goes down, for SVG. */
export function curvePoints(curve: Curve, range: ValueRange): string {
  const points = [[0, curve[0][1]] as const, ...curve, [1, curve.at(-1)![1]] as const];
  return points.map(([time, value]) => `${time},${Number((1 - shareOf(range, value)).toFixed(4))}`).join(' ');
}
