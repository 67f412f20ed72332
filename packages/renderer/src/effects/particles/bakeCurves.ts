import type { CurveKey, GradientKey, ParticleSettings } from './ParticleSettings';

/** Width of the baked curves (texels): the first texel is the beginning of a life, the last its end. */
export const CURVE_TEXELS = 256;
/** Number of rows of the baked curves: colour and opacity; size, and integral of the spin. */
export const CURVE_ROWS = 2;

type Curves = Pick<ParticleSettings, 'colorOverLife' | 'sizeOverLife' | 'spinOverLife'>;

/** Index of the first key after a time; the number of keys if there is none. */
function keyAfter(keys: readonly (CurveKey | GradientKey)[], time: number): number {
  let next = 0;
  while (next < keys.length && keys[next][0] <= time) next++;
  return next;
}

/** Value of a curve at a time. @param keys - ascending, at least one @param time - 0 to 1 */
export function curveAt(keys: readonly CurveKey[], time: number): number {
  const next = keyAfter(keys, time);
  if (next === 0) return keys[0][1];
  if (next === keys.length) return keys[next - 1][1];
  const [start, from] = keys[next - 1];
  const [end, to] = keys[next];
  return from + ((time - start) / (end - start)) * (to - from);
}

/**
 * Writes colour (linear) and opacity of a gradient.
 * @param keys - ascending, at least one
 * @param time - 0 to 1
 */
export function gradientAt(keys: readonly GradientKey[], time: number, out: Float32Array, at = 0): void {
  const next = keyAfter(keys, time);
  const [start, color, opacity] = keys[Math.max(0, next - 1)];
  const [end, toColor, toOpacity] = keys[Math.min(next, keys.length - 1)];
  const share = end > start ? (time - start) / (end - start) : 0;
  for (let i = 0; i < 3; i++) out[at + i] = color[i] + share * (toColor[i] - color[i]);
  out[at + 3] = opacity + share * (toOpacity - opacity);
}

/** Integral of a curve from 0 to a time. @param keys - ascending, at least one @param time - 0 to 1 */
export function curveIntegral(keys: readonly CurveKey[], time: number): number {
  let sum = 0;
  let last = 0;
  let value = curveAt(keys, 0);
  for (const [at, next] of keys) {
    if (at >= time) break;
    sum += ((value + (at === last ? value : curveBefore(keys, at))) / 2) * (at - last);
    last = at;
    value = next;
  }
  const end = curveBefore(keys, time);
  return sum + ((value + end) / 2) * (time - last);
}

/** Limit of a curve as time approaches from below: the value before a jump if two keys have that time. */
function curveBefore(keys: readonly CurveKey[], time: number): number {
  const at = keys.findIndex((key) => key[0] >= time);
  if (at <= 0) return at === 0 ? keys[0][1] : keys[keys.length - 1][1];
  const [start, from] = keys[at - 1];
  const [end, to] = keys[at];
  return end > start ? from + ((time - start) / (end - start)) * (to - from) : from;
}

/** @returns 4 × CURVE_TEXELS × CURVE_ROWS floats */
export function bakeCurves(
  { colorOverLife, sizeOverLife, spinOverLife }: Curves,
  out = new Float32Array(4 * CURVE_TEXELS * CURVE_ROWS),
): Float32Array<ArrayBuffer> {
  for (let i = 0; i < CURVE_TEXELS; i++) {
    const time = i / (CURVE_TEXELS - 1);
    gradientAt(colorOverLife, time, out, 4 * i);
    const second = 4 * (CURVE_TEXELS + i);
    out[second] = curveAt(sizeOverLife, time);
    out[second + 1] = curveIntegral(spinOverLife, time);
  }
  return out;
}
