import { type GeneratorValue, asyncProperty, check, gen, PreconditionFailure } from 'fast-check';
import { FuzzRandom } from './FuzzRandom';
import { type FuzzCase, fuzzCase } from './generate';
import { type FuzzBudget, fuzzBudget, runCase } from './runCase';

/** Cases that are tried to make a failing one smaller, at most. */
const SHRINKS = 400;
/** Seconds after which no smaller case is tried: a case that is slow is slow each time. */
const SHRINKING = 60;

/** Result of a run of cases, which ends with the first that fails. */
export interface FuzzSummary {
  readonly seed: number;
  readonly cases: number;
  /** The case that failed, made as small as its fault allows, and the fault; null when none did. */
  readonly failure: { readonly given: FuzzCase; readonly fault: string } | null;
  /** Number of cases, and of those that opened, by kind of case. */
  readonly counts: Readonly<Record<string, { cases: number; taken: number }>>;
  /** Time of the slowest case. */
  readonly seconds: number;
  /** The largest part of its memory budget that a case took. */
  readonly memory: number;
}

/**
 * Opens generated and damaged files, one after the other.
 *
 * @param seed - of all of them
 * @param cases - how many
 * @param budget - what each may take
 */
export async function runCases(seed: number, cases: number, budget: FuzzBudget = fuzzBudget): Promise<FuzzSummary> {
  const counts: Record<string, { cases: number; taken: number }> = {};
  let [seconds, memory, shrinks, end] = [0, 0, 0, Infinity];
  let failure: FuzzSummary['failure'] = null;
  const property = asyncProperty(gen(), async (draw: GeneratorValue) => {
    if (failure && (shrinks++ >= SHRINKS || performance.now() > end)) throw new PreconditionFailure(true);
    const given = fuzzCase(new FuzzRandom(draw));
    const result = await runCase(given, budget);
    if (!failure) {
      const count = (counts[given.kind] ??= { cases: 0, taken: 0 });
      count.cases++;
      if (result.isTaken) count.taken++;
      seconds = Math.max(seconds, result.seconds);
      memory = Math.max(memory, result.memory / budget.memory(given.bytes.length));
    }
    if (result.failure === null) return;
    if (!failure) end = performance.now() + SHRINKING * 1000;
    // fast-check shrinks from the last failing case
    failure = { given, fault: result.failure };
    throw new Error(result.failure);
  });
  await check(property, { seed, numRuns: cases }).catch((error: unknown) => {
    // a case of very many draws overflows the stack of fast-check as it looks for smaller ones: it stays as large as it is
    if (failure === null) throw error;
  });
  return { seed, cases, failure, counts, seconds, memory };
}

/** A summary in one line, and what failed in another. */
export function summaryText({ seed, cases, failure, counts, seconds, memory }: FuzzSummary): string {
  const table = Object.entries(counts).map(([kind, each]) => `${kind} ${each.taken} of ${each.cases} taken`);
  return (
    `fuzz: seed ${seed}, ${cases} cases; ${table.join(', ')}; slowest ${seconds.toFixed(2)} s; ` +
    `most memory ${(memory * 100).toFixed(0)}% of its budget` +
    (failure ? `\n  ${failure.given.kind}: ${failure.fault}` : '')
  );
}
