import type { LabSeries } from '../plan/LabPlan';
import { shadingNames, shadings } from '../plan/lightKinds';
import { formatNumber } from '../words/format';
import { namedValue } from '../words/names';

/** Maps a value of an axis to pixels. */
export type Scale = (value: number) => number;

/** Types of scales; `symlog` is logarithmic but includes 0: log(1 + value). */
export type ScaleType = 'log' | 'linear' | 'symlog';

const transforms: Readonly<Record<ScaleType, Scale>> = {
  log: Math.log,
  linear: (value) => value,
  symlog: (value) => Math.sign(value) * Math.log1p(Math.abs(value)),
};

/** A scale from values to pixels; values outside of the domain are clamped to its ends. */
export function scaleOf(
  type: ScaleType,
  domain: readonly [number, number],
  [from, to]: readonly [number, number],
): Scale {
  const transform = transforms[type];
  const [low, high] = domain.map(transform);
  return (value) => {
    const share = (transform(Math.min(Math.max(value, domain[0]), domain[1])) - low) / (high - low || 1);
    return from + share * (to - from);
  };
}

/** Round ticks within bounds, about `count` of them: steps of 1, 2 or 5 times a power of ten. */
export function linearTicks(low: number, high: number, count: number): number[] {
  const rough = (high - low || 1) / Math.max(1, count);
  const power = 10 ** Math.floor(Math.log10(rough));
  const step =
    power *
    (rough / power >= Math.sqrt(50) ? 10 : rough / power >= Math.sqrt(10) ? 5 : rough / power >= Math.SQRT2 ? 2 : 1);
  const first = Math.ceil(low / step - 1e-9);
  const last = Math.floor(high / step + 1e-9);
  return Array.from({ length: last - first + 1 }, (_, i) => Number(((first + i) * step).toPrecision(12)));
}

/** Ticks at 1, 2 and 5 of each power of ten within bounds, fewer per power if there would be more than `most`. */
export function logTicks(low: number, high: number, most = 10): number[] {
  for (const steps of [[1, 2, 5], [1, 3], [1]]) {
    const ticks: number[] = [];
    for (let power = Math.floor(Math.log10(low)); power <= Math.ceil(Math.log10(high)); power++) {
      for (const step of steps) {
        const tick = Number((step * 10 ** power).toPrecision(1));
        if (tick >= low * 0.999 && tick <= high * 1.001) ticks.push(tick);
      }
    }
    if (ticks.length <= most) return ticks;
  }
  const power = Math.ceil(Math.log10(low));
  const stride = Math.ceil((Math.log10(high) - power + 1) / most);
  return Array.from({ length: most }, (_, i) => 10 ** (power + i * stride)).filter((tick) => tick <= high * 1.001);
}

/** Selects ticks whose texts do not overlap at `room` pixels each; the last tick is always kept. Values must ascend. */
export function ticksWithRoom(values: readonly number[], place: Scale, room: number): number[] {
  const kept: number[] = [];
  const last = values.at(-1);
  for (const value of values) {
    const free = kept.length === 0 || place(value) - place(kept.at(-1)!) >= room;
    const clear = value === last || last === undefined || place(last) - place(value) >= room;
    if ((free && clear) || value === last) kept.push(value);
  }
  return kept;
}

/** Short text of a tick on the axis of a series' values, without the unit. */
export function valueTick(series: LabSeries, value: number): string {
  if (series.axis === 'shading') return shadings[shadingNames[value]]?.label ?? String(value);
  if (series.axis === 'kind') return namedValue('kind', value);
  if (series.axis === 'pixels') return `${formatNumber(value / 1e6, 2)} M`;
  if (value >= 1e6) return `${formatNumber(value / 1e6)} M`;
  return value >= 10_000 ? `${formatNumber(value / 1000)}k` : formatNumber(value, 6);
}
