/** How many decimals are shown at most: where there is room, and in the three parts of a vector, fewer of large ones. */
export const shownDecimals = { long: 5, short: 3 } as const;

/** Smaller numbers are shown as 0: they come of calculating. */
const SMALLEST = 1e-8;

/** A number as text, without zeros at the end. One that would be shown as 0 and is not 0 keeps two digits. */
export function formatNumber(value: number, length: keyof typeof shownDecimals): string {
  const size = Math.abs(value);
  const fewer = length === 'long' || size < 10 ? 0 : size < 100 ? 1 : 2;
  const rounded = Number(value.toFixed(shownDecimals[length] - fewer));
  if (rounded === 0 && size >= SMALLEST) return String(Number(value.toPrecision(2)));
  return String(rounded + 0);
}
