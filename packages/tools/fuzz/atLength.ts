/**
 * What `npm run fuzz` bundles into one file and runs: many cases in several processes at once. That file runs wherever
 * Node is: `node fuzz.mjs --help`.
 */
import { fork } from 'node:child_process';
import { mkdirSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import type { FuzzCase } from './generate';
import { minimise } from './minimise';
import { runCase } from './runCase';
import { type FuzzSummary, runCases, summaryText } from './runCases';

const help = `npm run fuzz -- [cases] [seed] [options]
  cases            how many generated and damaged files are opened (default 100000)
  seed             of the first (default 1000000)
  --workers N      processes side by side (default: one for each processor)
  --out DIR        where failing files are written, cut down to what the fault needs (default .cache/fuzz)
  --pack FILE      makes one file of it that runs on another host by Node alone, and runs nothing`;

/** Cases that a process is given at a time. */
const BATCH = 500;
/** Most failing cases of a batch that are cut down and written. */
const WRITTEN = 20;

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    workers: { type: 'string', default: String(availableParallelism()) },
    out: { type: 'string', default: '.cache/fuzz' },
    help: { type: 'boolean', default: false },
  },
});
const out = resolve(values.out);

if (process.send) answerBatches();
else if (values.help) console.log(help);
else {
  process.exitCode = await main().catch((error: unknown) => {
    console.error(error instanceof Error ? error.message : error);
    return 1;
  });
}

/** A whole number that is given as an option. @throws Error naming the option */
function wholeNumber(name: string, text: string, least: number): number {
  const value = Number(text);
  if (Number.isSafeInteger(value) && value >= least) return value;
  throw new Error(`${name} ${text}: give a whole number of at least ${least}.`);
}

/** In a process of its own: runs the batches that its parent sends. */
function answerBatches(): void {
  // three tells the console of what it reads in models: that is no fault
  for (const method of ['warn', 'error', 'log'] as const) console[method] = () => {};
  process.on('message', ({ first, cases }: { first: number; cases: number }) => {
    let written = 0;
    const onFailure = async (given: FuzzCase, failure: string, seed: number): Promise<void> => {
      if (written++ >= WRITTEN) return;
      const small = await minimise(given, failure, async (each) => (await runCase(each)).failure);
      mkdirSync(out, { recursive: true });
      writeFileSync(join(out, `${seed}.${given.kind}`), small.bytes);
    };
    void runCases(first, cases, { onFailure }).then((summary) => process.send!(summary));
  });
}

/** @returns exit code: 0 when no case failed */
async function main(): Promise<number> {
  const [casesText = '100000', seedText = '1000000'] = positionals;
  const cases = wholeNumber('cases', casesText, 1);
  const seed = wholeNumber('seed', seedText, 0);
  const workers = wholeNumber('--workers', values.workers, 1);
  const begin = performance.now();
  const summaries: FuzzSummary[] = [];
  const ended: string[] = [];
  let next = 0;
  const work = (): Promise<void> =>
    new Promise((done) => {
      const child = fork(fileURLToPath(import.meta.url), ['--out', out]);
      let batch = '';
      const give = (): void => {
        if (next >= cases) {
          batch = '';
          child.disconnect();
          return;
        }
        const count = Math.min(BATCH, cases - next);
        batch = `${count} cases from seed ${seed + next}`;
        child.send({ first: seed + next, cases: count });
        next += count;
      };
      child.on('message', (summary: FuzzSummary) => {
        summaries.push(summary);
        console.log(summaryText(summary));
        for (const failure of summary.failures) console.log(`  ${failure}`);
        give();
      });
      child.on('exit', (code, signal) => {
        if (batch) ended.push(`a process ended (${signal ?? code}) within ${batch}`);
        done();
      });
      give();
    });
  await Promise.all(Array.from({ length: workers }, work));

  const all = summaries.reduce<FuzzSummary>(joined, summaries[0]);
  if (all)
    console.log(`\nAll of them, ${((performance.now() - begin) / 60_000).toFixed(1)} minutes, ${summaryText(all)}`);
  for (const each of ended) console.log(each);
  return ended.length === 0 && all?.failures.length === 0 ? 0 : 1;
}

/** Two summaries as one; the first again gives itself. */
function joined(a: FuzzSummary, b: FuzzSummary): FuzzSummary {
  if (a === b) return a;
  const counts = { ...a.counts };
  for (const [kind, { cases, taken }] of Object.entries(b.counts)) {
    const count = counts[kind] ?? { cases: 0, taken: 0 };
    counts[kind] = { cases: count.cases + cases, taken: count.taken + taken };
  }
  return {
    first: Math.min(a.first, b.first),
    cases: a.cases + b.cases,
    failures: [...a.failures, ...b.failures],
    counts,
    slowest: a.slowest.seconds > b.slowest.seconds ? a.slowest : b.slowest,
    largest: a.largest.ratio > b.largest.ratio ? a.largest : b.largest,
  };
}
