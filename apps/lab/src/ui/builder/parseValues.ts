/** Most values of a series: each is a case for every competitor. */
export const MOST_VALUES = 20;

/**
 * Parses whole numbers, separated by commas, semicolons or spaces; `1k` is 1,000.
 *
 * @returns the values in ascending order, each once; or the problem, a sentence
 */
export function parseValues(text: string): { values: number[] } | { problem: string } {
  const words = text.split(/[\s,;]+/).filter(Boolean);
  if (words.length === 0) return { problem: 'Give at least one value, as in 10, 100, 1000.' };
  const values = new Set<number>();
  for (const word of words) {
    const [, digits, thousand] = /^(\d+(?:\.\d+)?)(k?)$/i.exec(word) ?? [];
    const value = Number(digits) * (thousand ? 1000 : 1);
    if (!Number.isInteger(value)) return { problem: `“${word}” is no whole number: write 10, 100, 1000.` };
    if (value > 1e6) return { problem: `${word} is too large: 1,000,000 at most.` };
    values.add(value);
  }
  if (values.size > MOST_VALUES) {
    return { problem: `${values.size} values are too many: ${MOST_VALUES} at most.` };
  }
  return { values: [...values].sort((a, b) => a - b) };
}
