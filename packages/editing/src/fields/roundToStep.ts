/** Number of decimals kept in addition to the step's. */
const BEYOND = 9;

/**
 * Removes rounding errors of adding steps: 0.7 + 0.1 is 0.8. Typed digits are kept.
 * @param step - above 0
 */
export function roundToStep(value: number, step: number): number {
  const decimals = BEYOND - Math.floor(Math.log10(step));
  return Number(value.toFixed(Math.min(Math.max(decimals, 0), 20)));
}
