import { type ClipKey, cubicBezier } from '@farol/engine';

/** The inner control points x1, y1, x2, y2 of a Bézier curve from (0, 0) to (1, 1), as in CSS's `cubic-bezier`. */
export type CurveControl = NonNullable<ClipKey['control']>;

/** The control points of a straight line. */
export const STRAIGHT: CurveControl = [1 / 3, 1 / 3, 2 / 3, 2 / 3];

/** Presets of the easing menu. */
export const namedCurves = {
  easeIn: [0.42, 0, 1, 1],
  easeOut: [0, 0, 0.58, 1],
  easeInOut: [0.42, 0, 0.58, 1],
} as const satisfies Record<string, CurveControl>;

/** Parts of a curve smaller than this are treated as straight. */
const SMALLEST = 1e-9;
/** Bisection steps that determine a number in [0, 1] to double precision. */
const HALVINGS = 52;

/** One coordinate of the curve at its parameter u, 0 to 1. */
const coordinate = (u: number, first: number, second: number): number =>
  3 * (1 - u) * (1 - u) * u * first + 3 * (1 - u) * u * u * second + u * u * u;

/** Curve parameter at a share of the time, 0 to 1; by bisection, since x is monotonic. */
function parameterAt(share: number, [x1, , x2]: CurveControl): number {
  let [low, high] = [0, 1];
  for (let i = 0; i < HALVINGS; i++) {
    const middle = (low + high) / 2;
    if (coordinate(middle, x1, x2) < share) low = middle;
    else high = middle;
  }
  return (low + high) / 2;
}

/** Progress of the value at a share of the time, both 0 to 1. */
export const curveAt = (share: number, [x1, y1, x2, y2]: CurveControl = STRAIGHT): number =>
  cubicBezier(x1, y1, x2, y2, share);

const mix = (a: number, b: number, t: number): number => a + (b - a) * t;

/**
 * Splits a curve in two that together are the same curve.
 * @param share - share of the time, above 0 and below 1
 * @returns progress at the split, and both parts' control points relative to their own extent. A part that begins and
 *   ends at the same progress becomes straight. A handle whose time would be outside of its part, as with curves steep
 *   in the middle, is clamped.
 */
export function splitCurve(
  share: number,
  control: CurveControl = STRAIGHT,
): { way: number; before: CurveControl; after: CurveControl } {
  const u = parameterAt(share, control);
  const [x1, y1, x2, y2] = control;
  /** De Casteljau subdivision: the points of both halves along one axis. */
  const halves = (first: number, second: number): [number, number, number, number, number] => {
    const a = mix(0, first, u);
    const b = mix(first, second, u);
    const c = mix(second, 1, u);
    return [a, mix(a, b, u), mix(mix(a, b, u), mix(b, c, u), u), mix(b, c, u), c];
  };
  const [xa, xb, x, xc, xd] = halves(x1, x2);
  const [ya, yb, way, yc, yd] = halves(y1, y2);
  const limit = (value: number): number => Math.min(Math.max(value, 0), 1);
  const part = (xs: readonly number[], ys: readonly number[], [x0, y0]: number[], [x3, y3]: number[]): CurveControl => {
    if (Math.abs(y3 - y0) < SMALLEST || x3 - x0 < SMALLEST) return STRAIGHT;
    const inX = (value: number): number => limit((value - x0) / (x3 - x0));
    const inY = (value: number): number => (value - y0) / (y3 - y0);
    return [inX(xs[0]), inY(ys[0]), inX(xs[1]), inY(ys[1])];
  };
  return {
    way,
    before: part([xa, xb], [ya, yb], [0, 0], [x, way]),
    after: part([xc, xd], [yc, yd], [x, way], [1, 1]),
  };
}
