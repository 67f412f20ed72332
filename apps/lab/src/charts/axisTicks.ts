import type { LabSeries } from '../plan/LabPlan';
import { shadingNames, shadings } from '../plan/lightKinds';
import { formatNumber } from '../words/format';
import { namedValue } from '../words/names';

/** Ticks at 1, 2 and 5 of each power of ten within bounds, fewer where there are many powers. */
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

/** Of values in ascending order those whose texts find room, the first and the last among them. */
export function ticksWithRoom(values: readonly number[], place: (value: number) => number, room: number): number[] {
  const kept: number[] = [];
  const last = values.at(-1);
  for (const value of values) {
    const free = kept.length === 0 || place(value) - place(kept.at(-1)!) >= room;
    const clear = value === last || last === undefined || place(last) - place(value) >= room;
    if ((free && clear) || value === last) kept.push(value);
  }
  return kept;
}

/** Text of a tick of a series: short, without the unit. */
export function valueTick(series: LabSeries, value: number): string {
  if (series.axis === 'shading') return shadings[shadingNames[value]]?.label ?? String(value);
  if (series.axis === 'kind') return namedValue('kind', value);
  if (series.axis === 'pixels') return `${formatNumber(value / 1e6, 2)} M`;
  if (value >= 1e6) return `${formatNumber(value / 1e6)} M`;
  return value >= 10_000 ? `${formatNumber(value / 1000)}k` : formatNumber(value, 6);
}
