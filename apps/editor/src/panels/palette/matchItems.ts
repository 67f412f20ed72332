/** An item that is searched by its label. */
export interface Findable {
  readonly label: string;
  /** Group shown with the item, such as 'Technique'. */
  readonly group: string;
  /** Text, such as a help text, in which whole words are searched; matches rank below those in label and group. */
  readonly help?: string;
}

/** Rank of a word that occurs only in an item's help. */
const HELPED = 0.5;

/** Rank of a text for a query whose letters it contains in order; 0 when it does not. */
function score(text: string, query: string): number {
  const whole = text.indexOf(query);
  if (whole >= 0) return 1000 - whole + (whole === 0 || /[\s:-]/.test(text[whole - 1]) ? 500 : 0);
  let at = -1;
  let sum = 0;
  for (const letter of query) {
    const next = text.indexOf(letter, at + 1);
    if (next < 0) return 0;
    // letters that begin words, or follow one another, rank higher
    sum += next === at + 1 ? 8 : next === 0 || /[\s:-]/.test(text[next - 1]) ? 6 : 1;
    at = next;
  }
  return sum / text.length;
}

/** The items that match every word of a query, best first; all of them, in their order, for an empty query. */
export function matchItems<T extends Findable>(items: readonly T[], query: string): T[] {
  const words = query.toLowerCase().split(/\s+/).filter(Boolean);
  if (words.length === 0) return [...items];
  return items
    .map((item) => {
      const text = `${item.label} ${item.group}`.toLowerCase();
      const help = item.help?.toLowerCase() ?? '';
      const scores = words.map((word) => score(text, word) || (word.length > 2 && help.includes(word) ? HELPED : 0));
      const whole = words.join(' ') === item.label.toLowerCase() ? 1 : 0;
      return { item, sum: scores.includes(0) ? 0 : scores.reduce((a, b) => a + b, whole) };
    })
    .filter(({ sum }) => sum > 0)
    .toSorted((a, b) => b.sum - a.sum)
    .map(({ item }) => item);
}
