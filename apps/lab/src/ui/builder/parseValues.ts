import { t } from '@farol/editing';

/** Maximum number of values of a series: each is a case for every competitor. */
export const MOST_VALUES = 20;

/**
 * Parses whole numbers, separated by commas, semicolons or spaces; `1k` is 1,000.
 *
 * @returns the values in ascending order, each once; or the problem, a sentence
 */
export function parseValues(text: string): { values: number[] } | { problem: string } {
  const words = text.split(/[\s,;]+/).filter(Boolean);
  if (words.length === 0) return { problem: t('Give at least one value, as in 10, 100, 1000.') };
  const values = new Set<number>();
  for (const word of words) {
    const [, digits, thousand] = /^(\d+(?:\.\d+)?)(k?)$/i.exec(word) ?? [];
    const value = Number(digits) * (thousand ? 1000 : 1);
    if (!Number.isInteger(value)) return { problem: t('“{word}” is no whole number: write 10, 100, 1000.', { word }) };
    if (value > 1e6) return { problem: t('{word} is too large: a million at most.', { word }) };
    values.add(value);
  }
  if (values.size > MOST_VALUES) {
    return { problem: t('{count} values are too many: {most} at most.', { count: values.size, most: MOST_VALUES }) };
  }
  return { values: [...values].sort((a, b) => a - b) };
}
