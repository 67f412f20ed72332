/** A number with its thousands apart, for messages. */
export const counted = (count: number): string => count.toLocaleString('en');
