/**
 * Entry that `npm run fuzz` bundles into one file and runs: many cases in several processes at once. The file needs
 * Node alone: `node fuzz.mjs --help`.
 */
import { fork } from 'node:child_process';
import { mkdirSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { type FuzzSummary, runCases, summaryText } from './runCases';

const help = `npm run fuzz -- [cases] [seed] [options]
  cases            how many generated and damaged files are opened (default 100000)
  seed             of the first batch of 100 (default 1000000)
  --workers N      processes side by side (default: one for each processor)
  --out DIR        where failing files are written, made as small as the fault allows (default .cache/fuzz)
  --pack FILE      makes one file of it that runs on another host by Node alone, and runs nothing`;

/** Cases that a process is given at a time; the first that fails ends them. */
const BATCH = 100;

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

/** Runs the batches that the parent process sends, in a child process. */
function answerBatches(): void {
  // three writes warnings about damaged models to the console: they are no fault
  for (const method of ['warn', 'error', 'log'] as const) console[method] = () => {};
  process.on('message', ({ seed, cases }: { seed: number; cases: number }) => {
    void runCases(seed, cases).then((summary) => {
      if (summary.failure) {
        const { kind, bytes } = summary.failure.given;
        mkdirSync(out, { recursive: true });
        writeFileSync(join(out, `${seed}.${kind}`), bytes);
      }
      process.send!(summary);
    });
  });
}

/** @returns exit code: 0 when no case failed */
async function main(): Promise<number> {
  const [casesText = '100000', seedText = '1000000'] = positionals;
  const cases = wholeNumber('cases', casesText, 1);
  const seed = wholeNumber('seed', seedText, 0);
  const workers = wholeNumber('--workers', values.workers, 1);
  const begin = performance.now();
  const ended: string[] = [];
  let [next, failed] = [0, 0];
  const work = (): Promise<void> =>
    new Promise((done) => {
      const child = fork(fileURLToPath(import.meta.url), ['--out', out]);
      let batch = '';
      const give = (): void => {
        const from = next++;
        const count = Math.min(BATCH, cases - from * BATCH);
        if (count <= 0) {
          batch = '';
          child.disconnect();
          return;
        }
        batch = `${count} cases of seed ${seed + from}`;
        child.send({ seed: seed + from, cases: count });
      };
      child.on('message', (summary: FuzzSummary) => {
        if (summary.failure) failed++;
        console.log(summaryText(summary));
        give();
      });
      child.on('exit', (code, signal) => {
        if (batch) ended.push(`a process ended (${signal ?? code}) within ${batch}`);
        done();
      });
      give();
    });
  await Promise.all(Array.from({ length: workers }, work));
  const minutes = ((performance.now() - begin) / 60_000).toFixed(1);
  const where = failed > 0 ? `, whose files are in ${out}` : '';
  console.log(`\n${cases} cases in ${minutes} minutes; ${failed} batches of ${BATCH} failed${where}`);
  for (const each of ended) console.log(each);
  return ended.length + failed === 0 ? 0 : 1;
}
