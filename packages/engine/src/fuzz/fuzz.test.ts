import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { fuzzCase, type FuzzCase, type FuzzKind } from './generate';
import { minimise } from './minimise';
import { fuzzBudget, runCase } from './runCase';

/** `npm run fuzz` sets these: how many cases, the first seed, where failing ones are written. */
const { FAROL_FUZZ_CASES, FAROL_FUZZ_SEED, FAROL_FUZZ_OUT } = process.env;
const cases = Number(FAROL_FUZZ_CASES ?? 2000);
const seed = Number(FAROL_FUZZ_SEED ?? 1);
const found = join(import.meta.dirname, 'found');

// three tells the console of what it reads in models: that is no fault
beforeEach(() => {
  for (const method of ['warn', 'error', 'log'] as const) vi.spyOn(console, method).mockImplementation(() => {});
});
afterEach(() => {
  vi.restoreAllMocks();
});

const failureOf = async (given: FuzzCase): Promise<string | null> => (await runCase(given)).failure;

/** Cases of one test: a long run tells how far it is, and each part has an hour. */
const BATCH = 5000;
const batches = Array.from({ length: Math.ceil(cases / BATCH) }, (_, i) => ({
  first: seed + i * BATCH,
  count: Math.min(BATCH, cases - i * BATCH),
}));

test.each(batches)(
  '$count cases from seed $first open, or are refused, within their budget',
  async ({ first, count: all }) => {
    const failures: string[] = [];
    const counts: Record<string, { cases: number; taken: number }> = {};
    let slowest = { seconds: 0, seed: 0 };
    let largest = { ratio: 0, seed: 0 };
    for (let i = 0; i < all; i++) {
      const given = fuzzCase(first + i);
      const result = await runCase(given);
      const count = (counts[given.kind] ??= { cases: 0, taken: 0 });
      count.cases++;
      if (result.isTaken) count.taken++;
      if (result.seconds > slowest.seconds) slowest = { seconds: result.seconds, seed: first + i };
      const ratio = result.memory / fuzzBudget.memory(given.bytes.length);
      if (ratio > largest.ratio) largest = { ratio, seed: first + i };
      if (result.failure === null) continue;
      failures.push(`seed ${first + i}, ${given.kind}: ${result.failure}`);
      if (FAROL_FUZZ_OUT && failures.length <= 50) {
        const small = await minimise(given, result.failure, failureOf);
        mkdirSync(FAROL_FUZZ_OUT, { recursive: true });
        writeFileSync(join(FAROL_FUZZ_OUT, `${first + i}.${given.kind}`), small.bytes);
      }
    }
    const table = Object.entries(counts).map(([kind, each]) => `${kind} ${each.taken} of ${each.cases} taken`);
    process.stdout.write(
      `fuzz: seed ${first}, ${all} cases, ${failures.length} failed; ${table.join(', ')}; slowest ${slowest.seconds.toFixed(2)} s ` +
        `(seed ${slowest.seed}); most memory ${(largest.ratio * 100).toFixed(0)}% of its budget (seed ${largest.seed})\n`,
    );
    expect(failures.slice(0, 20)).toEqual([]);
    // a generator whose files are all refused tries little
    expect(Object.values(counts).every(({ taken }) => taken > 0) || all < 500).toBe(true);
  },
  3_600_000,
);

test.each(readdirSync(found).filter((name) => name !== 'README.md'))('what was found once: %s', async (name) => {
  const bytes = new Uint8Array(readFileSync(join(found, name)));
  expect(await failureOf({ kind: name.split('.').at(-1) as FuzzKind, bytes })).toBeNull();
});
