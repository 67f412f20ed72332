import { formatCount, shortText, t } from '@farol/editing';

/** Names for a message: the first ones of a list, shortened, and the number of others. */
export function firstNames(names: readonly string[], most: number): string {
  const rest = names.length - most;
  const more = rest > 0 ? t(' and {count} more', { count: formatCount(rest) }) : '';
  const shown = names.slice(0, most).map((name) => shortText(name, 80));
  return shown.join(', ') + more;
}
