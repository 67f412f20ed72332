import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { extent, isWhole } from '@farol/tools/extent';
import { asyncProperty, check, gen, type GeneratorValue } from 'fast-check';
import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { FuzzRandom } from './FuzzRandom';
import { fuzzCase, type FuzzKind, fuzzKinds } from './generate';
import { fuzzBudget, runCase } from './runCase';
import { runCases, summaryText } from './runCases';

const found = join(import.meta.dirname, 'found');

// three tells the console of what it reads in models: that is no fault
beforeEach(() => {
  for (const method of ['warn', 'error', 'log'] as const) vi.spyOn(console, method).mockImplementation(() => {});
});
afterEach(() => {
  vi.restoreAllMocks();
});

const cases = { slice: 120, verify: 2000, long: 20_000 }[extent];
// time is judged in verify alone
const budget = isWhole ? fuzzBudget : { ...fuzzBudget, seconds: Infinity };

test(`${cases} cases open, or are refused, within their budget`, async () => {
  const summary = await runCases(1, cases, budget);
  process.stdout.write(`${summaryText(summary)}\n`);
  expect(summary.failure?.fault ?? null).toBeNull();
}, 3_600_000);

// a generator whose files are all refused tries little; a fifth of them opens, whatever components there are
test.each(fuzzKinds)('a generated case of kind %s opens', async (kind) => {
  const isRefused = async (draw: GeneratorValue): Promise<boolean> =>
    !(await runCase(fuzzCase(new FuzzRandom(draw), kind), budget)).isTaken;
  const { failed } = await check(asyncProperty(gen(), isRefused), { seed: 1, numRuns: 200, endOnFailure: true });
  expect(failed).toBe(true);
});

test.each(readdirSync(found).filter((name) => name !== 'README.md'))('what was found once: %s', async (name) => {
  const bytes = new Uint8Array(readFileSync(join(found, name)));
  expect((await runCase({ kind: name.split('.').at(-1) as FuzzKind, bytes }, budget)).failure).toBeNull();
});
