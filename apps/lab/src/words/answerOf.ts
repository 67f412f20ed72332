import type { LabRun } from '../results/LabRun';
import { casesOf } from './seriesCases';
import { type Winners, winnersOf } from './winners';

/** Maximum number of lights in a case with few lights, and minimum number in a case with many. */
export const [FEW, MANY] = [30, 100];

/** Fastest competitor of a run over its cases. */
export interface Answer {
  /** Key of the competitor that is fastest, or ties with the fastest, in most cases. */
  readonly best: string;
  readonly wins: number;
  /** Number of cases that at least two competitors have drawn. */
  readonly cases: number;
  /** Fastest over the cases of at most `FEW` lights, and of `MANY` or more; null without such cases. */
  readonly few: string | null;
  readonly many: string | null;
}

/** Fastest competitor by frame times; null while no case has two times. */
export function answerOf(run: LabRun): Answer | null {
  const contests = casesOf(run).flatMap(({ series, index, labCase }) => {
    const winners = winnersOf(run, series, index, 'frame');
    return winners && winners.entries.length > 1 ? [{ winners, lights: labCase.lights }] : [];
  });
  const all = fastestOf(contests.map(({ winners }) => winners));
  if (all === null) return null;
  const within = (low: number, high: number): string | null =>
    fastestOf(
      contests.flatMap(({ winners, lights }) => (lights !== null && lights >= low && lights <= high ? winners : [])),
    )?.name ?? null;
  return { best: all.name, wins: all.wins, cases: contests.length, few: within(0, FEW), many: within(MANY, Infinity) };
}

/** Competitor with most wins; among equals, the one whose times exceed the shortest ones by the least in total. */
function fastestOf(contests: readonly Winners[]): { name: string; wins: number } | null {
  const found = new Map<string, { wins: number; loss: number }>();
  for (const { best, names, entries } of contests) {
    for (const { competitor, time } of entries) {
      const sum = found.get(competitor) ?? { wins: 0, loss: 0 };
      found.set(competitor, sum);
      if (names.includes(competitor)) sum.wins++;
      sum.loss += Math.log(time.median / best.time.median);
    }
  }
  const [first] = [...found].sort(([, a], [, b]) => b.wins - a.wins || a.loss - b.loss);
  return first === undefined ? null : { name: first[0], wins: first[1].wins };
}
