/** Number of decimals that are kept beyond those of the step. */
const BEYOND = 9;

/**
 * A number without the digits that adding steps leaves behind: 0.7 + 0.1 is 0.8. Digits that somebody typed stay.
 * @param step - above 0
 */
export function roundToStep(value: number, step: number): number {
  const decimals = BEYOND - Math.floor(Math.log10(step));
  return Number(value.toFixed(Math.min(Math.max(decimals, 0), 20)));
}
