import { capital, listOf } from './format';
import { competitorWord } from './names';
import type { Winners } from './winners';

/** How many cases each wins, and how many are ties. */
export function mapWords(winners: readonly Winners[]): string[] {
  if (winners.length === 0) return ['Nothing has been measured here yet.'];
  const wins = new Map<string, number>();
  for (const { names } of winners) if (names.length === 1) wins.set(names[0], (wins.get(names[0]) ?? 0) + 1);
  const ties = winners.filter(({ names }) => names.length > 1);
  const sorted = [...wins].sort((a, b) => b[1] - a[1]);
  const all = winners.length === 1 ? 'In the one case' : `Of ${winners.length} cases`;
  const parts = sorted.map(([name, count]) => `${competitorWord(name)} wins ${count}`);
  const tied =
    ties.length === 0 ? '' : `${ties.length} ${ties.length === 1 ? 'is a tie' : 'are ties'} within the spread`;
  const sentences = [
    parts.length > 0
      ? `${all} ${listOf(parts)}${tied ? `; ${tied}` : ''}.`
      : `${capital(all)} none has one winner: ${tied}.`,
  ];
  const never = new Set(winners.flatMap(({ entries }) => entries.map(({ competitor }) => competitor)));
  if (winners.length > 2 && never.size > 1 && sorted[0]?.[1] === winners.length) {
    return [`${capital(competitorWord(sorted[0][0]))} wins all ${winners.length} cases.`];
  }
  return sentences;
}
