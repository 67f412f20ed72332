import type { LabRun, Metric } from '../results/LabRun';
import { compareSpreads, timeOf } from './compareSpreads';
import { capital, formatMs, formatPercent } from './format';
import { competitorWord, isTechnique } from './names';
import { entriesOf, type Entry } from './rowsOf';
import { casesOf, type SeriesCase } from './seriesCases';

/** What `auto` lost in a case. */
export interface Regret {
  readonly of: SeriesCase;
  readonly auto: Entry;
  readonly best: Entry;
  /** Technique that `auto` chose; null where the run does not tell. */
  readonly choice: string | null;
  /** `auto`’s time over the best technique’s, less 1: 0.05 for 5% longer. Below 0 where noise favours `auto`. */
  readonly regret: number;
  /** Whether the two times tie. */
  readonly isTie: boolean;
}

/** `auto` against the best of Farol’s techniques, in each case that both drew. */
export function regretsOf(run: LabRun, metric: Metric): Regret[] {
  return casesOf(run).flatMap((of) => {
    const entries = entriesOf(run, of.series, of.index, metric);
    const auto = entries.find(({ competitor }) => competitor === 'auto');
    const best = entries.find(({ competitor }) => isTechnique(competitor));
    if (!auto || !best || !timeOf(auto.row, metric)) return [];
    const regret = auto.time.median / best.time.median - 1;
    return [{ of, auto, best, choice: auto.row.technique, regret, isTie: compareSpreads(auto.time, best.time) === 0 }];
  });
}

/** Mean and worst regret, and what would have been better there. */
export function regretWords(regrets: readonly Regret[]): string[] {
  if (regrets.length === 0) return ['auto and the techniques it chooses from were not measured in one case.'];
  const mean = regrets.reduce((sum, { regret }) => sum + regret, 0) / regrets.length;
  const worst = regrets.reduce((a, b) => (b.regret > a.regret ? b : a));
  const sure = regrets.filter(({ isTie, regret }) => !isTie && regret > 0);
  const cases = regrets.length === 1 ? 'The one case' : `${regrets.length} cases`;
  const first =
    regrets.length === 1
      ? `auto took ${difference(mean)} the best technique in the one case measured.`
      : `Over ${cases} auto took ${difference(mean)} the best technique on average.`;
  if (sure.length === 0) {
    return [capital(first), 'In no case is it surely slower: the differences are within the spread.'];
  }
  const chose = worst.choice === null ? 'auto' : competitorWord(worst.choice);
  const { best, auto } = worst;
  const unsure = regrets.length - sure.length;
  if (regrets.length === 1) {
    const figures = `${formatMs(auto.time.median)}, ${competitorWord(best.competitor)} ${formatMs(best.time.median)}`;
    return [`${capital(first)}`, `It drew by ${chose}: ${figures}.`];
  }
  return [
    capital(first),
    `Worst: ${formatPercent(worst.regret)} with ${worst.of.label} (${chose} ${formatMs(auto.time.median)}, ` +
      `${competitorWord(best.competitor)} ${formatMs(best.time.median)}${worst.isTie ? '; the spread makes it unsure' : ''}).`,
    ...(unsure > 0 ? [`In ${unsure} of the cases the difference is within the spread.`] : []),
  ];
}

function difference(mean: number): string {
  return mean >= 0 ? `${formatPercent(mean)} longer than` : `${formatPercent(-mean)} less than`;
}
