/** How many decimals are shown at most: where there is room, and in the three parts of a vector. */
export const shownDecimals = { long: 5, short: 3 } as const;

/** A number as text, without zeros at the end. */
export function formatNumber(value: number, length: keyof typeof shownDecimals): string {
  return String(Number(value.toFixed(shownDecimals[length])));
}
