import { type FuzzCase, fuzzCase } from './generate';
import { type FuzzBudget, fuzzBudget, runCase } from './runCase';

/** What came of a run of cases. */
export interface FuzzSummary {
  /** Seed of the first case; each case has the seed after the one before. */
  readonly first: number;
  readonly cases: number;
  /** A line for each case that failed: its seed, kind and fault. */
  readonly failures: readonly string[];
  /** By kind of case: how many there were, and how many opened. */
  readonly counts: Readonly<Record<string, { cases: number; taken: number }>>;
  /** The case that took longest. */
  readonly slowest: { readonly seconds: number; readonly seed: number };
  /** The case that took the largest part of the memory that it may take. */
  readonly largest: { readonly ratio: number; readonly seed: number };
}

export interface FuzzOptions {
  readonly onFailure?: (given: FuzzCase, failure: string, seed: number) => Promise<void>;
  readonly budget?: FuzzBudget;
}

/**
 * Opens generated and damaged files, one after the other.
 *
 * @param first - seed of the first case
 * @param cases - how many
 * @param options.onFailure - told of each case that failed
 * @param options.budget - what each may take
 */
export async function runCases(
  first: number,
  cases: number,
  { onFailure, budget = fuzzBudget }: FuzzOptions = {},
): Promise<FuzzSummary> {
  const failures: string[] = [];
  const counts: Record<string, { cases: number; taken: number }> = {};
  let slowest = { seconds: 0, seed: first };
  let largest = { ratio: 0, seed: first };
  for (let seed = first; seed < first + cases; seed++) {
    const given = fuzzCase(seed);
    const { failure, isTaken, seconds, memory } = await runCase(given, budget);
    const count = (counts[given.kind] ??= { cases: 0, taken: 0 });
    count.cases++;
    if (isTaken) count.taken++;
    if (seconds > slowest.seconds) slowest = { seconds, seed };
    const ratio = memory / budget.memory(given.bytes.length);
    if (ratio > largest.ratio) largest = { ratio, seed };
    if (failure === null) continue;
    failures.push(`seed ${seed}, ${given.kind}: ${failure}`);
    await onFailure?.(given, failure, seed);
  }
  return { first, cases, failures, counts, slowest, largest };
}

/** A summary in one line. */
export function summaryText({ first, cases, failures, counts, slowest, largest }: FuzzSummary): string {
  const table = Object.entries(counts).map(([kind, each]) => `${kind} ${each.taken} of ${each.cases} taken`);
  return (
    `fuzz: seed ${first}, ${cases} cases, ${failures.length} failed; ${table.join(', ')}; ` +
    `slowest ${slowest.seconds.toFixed(2)} s (seed ${slowest.seed}); ` +
    `most memory ${(largest.ratio * 100).toFixed(0)}% of its budget (seed ${largest.seed})`
  );
}
