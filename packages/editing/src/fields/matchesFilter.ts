/** Splits a filter into words, in lower case. */
export const wordsOfFilter = (text: string): readonly string[] => text.toLowerCase().split(/\s+/).filter(Boolean);

/** Whether each word is in one of the texts: label and name of a field, title of its section. */
export function matchesFilter(words: readonly string[], texts: readonly string[]): boolean {
  const text = texts.join('\n').toLowerCase();
  return words.every((word) => text.includes(word));
}
