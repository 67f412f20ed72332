/** Tolerance of the solved x; the resulting y is right to about 1e-12. */
const ACCURACY = 1e-13;

/** A coordinate of the curve from 0 to 1 with inner control points a and b. */
const at = (t: number, a: number, b: number): number => ((1 + 3 * a - 3 * b) * t + 3 * b - 6 * a) * t * t + 3 * a * t;

const slopeAt = (t: number, a: number, b: number): number =>
  (3 * (1 + 3 * a - 3 * b) * t + 2 * (3 * b - 6 * a)) * t + 3 * a;

/**
 * Curve of CSS's `cubic-bezier(x1, y1, x2, y2)`: y (progress of the value) at x (progress of time).
 * @param x1 - 0 to 1, as `x2`
 * @param x - 0 to 1
 * @see https://www.w3.org/TR/css-easing-1/#cubic-bezier-easing-functions
 */
export function cubicBezier(x1: number, y1: number, x2: number, y2: number, x: number): number {
  if (x <= 0) return 0;
  if (x >= 1) return 1;
  if (x1 === y1 && x2 === y2) return x;
  // Newton iterations, kept within bisection bounds
  let low = 0;
  let high = 1;
  let t = x;
  for (let i = 0; i < 60; i++) {
    const error = at(t, x1, x2) - x;
    if (Math.abs(error) < ACCURACY) break;
    if (error < 0) low = t;
    else high = t;
    const slope = slopeAt(t, x1, x2);
    const next = slope > 1e-6 ? t - error / slope : -1;
    t = next > low && next < high ? next : (low + high) / 2;
  }
  return at(t, y1, y2);
}
