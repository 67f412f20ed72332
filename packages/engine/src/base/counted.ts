/** Formats a number with separated thousands, for messages. */
export const counted = (count: number): string => count.toLocaleString('en');
