import type { Curve, CurveField } from '@farol/engine/fields';

/** Value range of a curve's graph. */
export interface ValueRange {
  readonly low: number;
  readonly high: number;
}

const ROUND = [1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8, 10];

/** Rounds a number above 0 up to one of `ROUND` times a power of ten. */
function roundUp(value: number): number {
  const unit = 10 ** Math.floor(Math.log10(value));
  return (ROUND.find((each) => each >= value / unit - 1e-9) ?? 10) * unit;
}

/** The range that contains all keys of a curve, with space above them, within the field's limits. */
export function valueRange({ min = -Infinity, max = Infinity }: CurveField, curve: Curve): ValueRange {
  const values = curve.map(([, value]) => value);
  const largest = Math.max(...values);
  const smallest = Math.min(...values);
  const high = largest > 0 ? roundUp(largest * 1.1) : smallest < 0 ? 0 : 1;
  const low = smallest < 0 ? -roundUp(-smallest * 1.1) : 0;
  return { low: Math.max(low, min), high: Math.min(high, max) };
}

/** Position of a value between bottom (0) and top (1). */
export const shareOf = ({ low, high }: ValueRange, value: number): number =>
  high > low ? Math.min(Math.max((value - low) / (high - low), 0), 1) : 0.5;

/** The value at a position from 0 to 1, rounded to the graph's resolution. */
export function valueAtShare({ low, high }: ValueRange, share: number): number {
  const unit = 10 ** Math.floor(Math.log10((high - low) / 100));
  const value = Math.round((low + Math.min(Math.max(share, 0), 1) * (high - low)) / unit) * unit;
  return Math.min(Math.max(Number(value.toPrecision(12)), low), high);
}

/** Points of a curve for an SVG polyline, in a unit square with y down. */
export function curvePoints(curve: Curve, range: ValueRange): string {
  const points = [[0, curve[0][1]] as const, ...curve, [1, curve.at(-1)![1]] as const];
  return points.map(([time, value]) => `${time},${Number((1 - shareOf(range, value)).toFixed(4))}`).join(' ');
}
