/**
 * Greatest number of decimals shown: `long` in a single field, `short` in the three fields of a vector; large numbers
 * show fewer.
 */
export const shownDecimals = { long: 5, short: 3 } as const;

/** Numbers below this are shown as 0: they are rounding errors. */
const SMALLEST = 1e-8;

/** A number as text, without zeros at the end. One that would be shown as 0 and is not 0 keeps two digits. */
export function formatNumber(value: number, length: keyof typeof shownDecimals): string {
  const size = Math.abs(value);
  const fewer = length === 'long' || size < 10 ? 0 : size < 100 ? 1 : 2;
  const rounded = Number(value.toFixed(shownDecimals[length] - fewer));
  if (rounded === 0 && size >= SMALLEST) return String(Number(value.toPrecision(2)));
  return String(rounded + 0);
}
