/**
 * Greatest number of displayed decimals: `long` in a single field, `short` in the three fields of a vector; large
 * numbers have fewer.
 */
export const shownDecimals = { long: 5, short: 3 } as const;

/** Numbers smaller than this are displayed as 0, as rounding errors. */
const SMALLEST = 1e-8;

/** Greatest number of decimals: one more than `step` has, at least two, and enough for three significant digits. */
const decimalsBy = (step: number, size: number): number =>
  Math.max(2, Math.ceil(-Math.log10(step)) + 1, size === 0 ? 0 : 2 - Math.floor(Math.log10(size)));

/**
 * Formats a number without trailing zeros. A number that would be rounded to 0 keeps two digits.
 * @param step - smallest relevant change, above 0, which limits the decimals of a `long` number; unlimited when absent
 */
export function formatNumber(value: number, length: keyof typeof shownDecimals, step?: number): string {
  const size = Math.abs(value);
  const fewer = length === 'long' || size < 10 ? 0 : size < 100 ? 1 : 2;
  const most = shownDecimals[length] - fewer;
  const decimals = step === undefined || length === 'short' ? most : Math.min(most, decimalsBy(step, size));
  const rounded = Number(value.toFixed(decimals));
  if (rounded === 0 && size >= SMALLEST) return String(Number(value.toPrecision(2)));
  return String(rounded + 0);
}
