/**
 * Interpolates a table linearly; beyond its ends, returns the first or last value.
 * @param at - positions, ascending
 * @param values - values for the positions, from index `from` on
 */
export function interpolate(at: Float64Array, values: Float64Array, from: number, x: number): number {
  let low = 0;
  let high = at.length - 1;
  if (x <= at[low]) return values[from];
  if (x >= at[high]) return values[from + high];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (at[middle] <= x) low = middle;
    else high = middle;
  }
  const share = (x - at[low]) / (at[high] - at[low]);
  return (1 - share) * values[from + low] + share * values[from + high];
}
