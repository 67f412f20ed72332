import type { LabSeries } from '../plan/LabPlan';
import type { LabRun, Metric } from '../results/LabRun';
import { compareSpreads } from './compareSpreads';
import { entriesOf, type Entry } from './rowsOf';

/** Who is fastest in a case: several where the spreads do not tell them apart, the shortest median first. */
export interface Winners {
  readonly index: number;
  readonly value: number;
  readonly best: Entry;
  /** Keys of the fastest and of all that tie with it. */
  readonly names: readonly string[];
  /** Everybody's times, shortest first. */
  readonly entries: readonly Entry[];
}

/** The fastest of a case, `auto` left out: it draws by one of the others. Null where nobody has a time. */
export function winnersOf(run: LabRun, series: LabSeries, index: number, metric: Metric): Winners | null {
  const entries = entriesOf(run, series, index, metric).filter(({ competitor }) => competitor !== 'auto');
  if (entries.length === 0) return null;
  const [best] = entries;
  const names = entries.filter(({ time }) => compareSpreads(best.time, time) === 0).map(({ competitor }) => competitor);
  return { index, value: series.values[index], best, names, entries };
}

/** Cases in a row that the same competitors win. */
export interface WinningRange {
  /** One name, or several that tie in every case of the range. */
  readonly names: readonly string[];
  readonly cases: readonly Winners[];
}

/** A series as few ranges: each goes on while somebody who won its first case wins, alone or by a tie. */
export function winningRanges(cases: readonly Winners[]): WinningRange[] {
  const ranges: WinningRange[] = [];
  for (let start = 0; start < cases.length;) {
    let names = [...cases[start].names];
    let end = start + 1;
    while (end < cases.length) {
      const still = names.filter((name) => cases[end].names.includes(name));
      if (still.length === 0) break;
      names = still;
      end++;
    }
    const range = cases.slice(start, end);
    // who has the shortest median most often comes first
    const wins = (name: string): number => range.filter(({ best }) => best.competitor === name).length;
    ranges.push({ names: names.sort((a, b) => wins(b) - wins(a)), cases: range });
    start = end;
  }
  return ranges;
}
