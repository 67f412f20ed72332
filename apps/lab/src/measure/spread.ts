import type { Spread } from '../results/LabRun';

/**
 * Quantile with linear interpolation between order statistics; NaN without values.
 *
 * @param values - in any order
 * @param q - 0 to 1
 */
export function quantile(values: readonly number[], q: number): number {
  const sorted = [...values].sort((a, b) => a - b);
  const at = (sorted.length - 1) * q;
  const low = Math.floor(at);
  const high = Math.min(sorted.length - 1, low + 1);
  return sorted.length === 0 ? Number.NaN : sorted[low] + (sorted[high] - sorted[low]) * (at - low);
}

/** Median; NaN without values. */
export const median = (values: readonly number[]): number => quantile(values, 0.5);

/**
 * Median of the turns' medians, which a single disturbed turn does not change, and percentiles of all samples, in which
 * that turn is visible.
 *
 * @param turns - samples of each turn (ms); turns without samples are ignored
 * @returns null when no turn has samples
 */
export function spreadOf(turns: readonly (readonly number[])[]): Spread | null {
  const measured = turns.filter((turn) => turn.length > 0);
  if (measured.length === 0) return null;
  const all = measured.flat();
  return {
    median: median(measured.map(median)),
    low: quantile(all, 0.1),
    high: quantile(all, 0.9),
    samples: all.length,
  };
}
