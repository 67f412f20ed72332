import type { LabSeries } from '../plan/LabPlan';
import { compareSpreads } from './compareSpreads';
import { capital, formatFactor, formatMs, listOf } from './format';
import { competitorWord, valueText } from './names';
import type { Winners } from './winners';

/** What each later case of a series costs the competitor that is the fastest in the first one: a sentence, or none. */
export function costWords({ axis, values }: LabSeries, winners: readonly Winners[]): string[] {
  const [first, ...others] = winners;
  if (!first) return [];
  const { competitor, time } = first.best;
  const parts = others.flatMap(({ index, entries }) => {
    const its = entries.find((each) => each.competitor === competitor)?.time;
    if (!its) return [];
    const factor = its.median / time.median;
    const compared = factor >= 1 ? `${formatFactor(factor)} as long` : `${formatFactor(1 / factor)} as fast`;
    const cost = compareSpreads(its, time) === 0 ? 'the same within the spread' : compared;
    return [`with ${valueText(axis, values[index])} ${cost} (${formatMs(its.median)})`];
  });
  if (parts.length === 0) return [];
  const start = `${capital(competitorWord(competitor))} takes ${formatMs(time.median)}`;
  return [`${start} with ${valueText(axis, values[first.index])}, ${listOf(parts)}.`];
}
