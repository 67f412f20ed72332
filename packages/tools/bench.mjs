/**
 * `npm run bench`: with `--preset` measures what the Lab measures, by the Lab's own code (`benchLab.mjs`); without, scene ×
 * technique × lights × size in the viewer, in turns, and writes a table and JSON. `npm run bench -- --help` lists the
 * options. With `--dist` it needs Node and playwright-core alone.
 */
import { cpSync, mkdirSync, rmSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { BenchBrowser } from './benchBrowser.mjs';
import { buildApp, buildReference, commitOf, isBuilt } from './benchBuild.mjs';
import { benchCases, caseKey } from './benchCases.mjs';
import { benchLab } from './benchLab.mjs';
import { benchHelp, parseBenchOptions } from './benchOptions.mjs';
import { serveFolder } from './benchServe.mjs';
import { median, summarise } from './benchStatistics.mjs';
import { benchTable, digits } from './benchTable.mjs';
import { ensureBrowser } from './ensureBrowser.mjs';
import { ensureInstalled } from './ensureInstalled.mjs';
import { root } from './root.mjs';

/**
 * @typedef {import('./benchCases.mjs').BenchCase} BenchCase
 * @typedef {import('./benchMeasure.mjs').Measurement} Measurement
 * @typedef {import('./benchOptions.mjs').MatrixBench} BenchOptions
 * @typedef {{ name: string, folder: string }} Build
 * @typedef {{ benchCase: BenchCase, builds: ({ rounds: Measurement[], error: string | null } | null)[] }} CaseRecord
 */

try {
  const options = parseBenchOptions(process.argv.slice(2));
  if (options.help) console.log(benchHelp);
  else process.exitCode = await (options.mode === 'lab' ? benchLab(options) : bench(options));
} catch (error) {
  console.error(error instanceof Error ? error.message : error);
  process.exitCode = 1;
}

/** @param {BenchOptions} options @returns {Promise<number>} exit code: 0 when anything was measured */
async function bench(options) {
  const builds = await prepareBuilds(options);
  if (options.buildOnly) return keepBuilds(builds, options.out);
  const browser = new BenchBrowser({ executablePath: ensureBrowser(), gpu: options.gpu });
  const servers = await Promise.all(builds.map(({ folder }) => serveFolder(folder)));
  try {
    const known = [];
    for (const { url } of servers) known.push(await browser.known(url, Math.max(60, options.timeout)));
    const cases = benchCases(options, known);
    const urls = servers.map(({ url }) => url);
    const measured = await measureAll(options, { browser, builds, cases, urls });
    console.log(`\n${join(options.out, 'bench.md')} and bench.json`);
    return measured > 0 ? 0 : 1;
  } finally {
    await browser.close();
    for (const server of servers) await server.close();
  }
}

/**
 * @param {BenchOptions} options
 * @returns {Promise<Build[]>} this one, then the one to compare with
 */
async function prepareBuilds({ dist, against }) {
  /** @type {Build[]} */
  const builds = [];
  if (dist !== null) {
    if (!isBuilt(dist)) throw new Error(`--dist ${dist}: no index.html there; build the viewer with npm run build.`);
    builds.push({ name: 'now', folder: resolve(dist) });
  } else {
    ensureInstalled();
    console.log('Building the viewer.');
    builds.push({ name: 'now', folder: await buildApp(root, 'viewer') });
  }
  if (against !== null) {
    if (!isBuilt(against)) console.log(`Building the viewer of ${against}.`);
    const folder = isBuilt(against)
      ? resolve(against)
      : await buildReference(against, join(root, '.cache/bench/against'), 'viewer');
    builds.push({ name: against, folder });
  }
  return builds;
}

/** @param {Build[]} builds @param {string} out */
function keepBuilds(builds, out) {
  builds.forEach(({ folder }, index) => {
    const to = join(out, index === 0 ? 'now' : 'against');
    rmSync(to, { recursive: true, force: true });
    cpSync(folder, to, { recursive: true, filter: (path) => !path.startsWith(join(folder, 'types')) });
    console.log(to);
  });
  return 0;
}

/**
 * @param {BenchOptions} options
 * @param {{ browser: BenchBrowser, builds: Build[], cases: BenchCase[], urls: string[] }} world
 * @returns {Promise<number>} how many measurements there are
 */
async function measureAll(options, { browser, builds, cases, urls }) {
  const { rounds, minutes } = options;
  /** @type {Map<string, CaseRecord>} */
  const records = new Map();
  for (const benchCase of cases) {
    const record = records.get(caseKey(benchCase)) ?? { benchCase, builds: builds.map(() => null) };
    record.builds[benchCase.build] = { rounds: [], error: null };
    records.set(caseKey(benchCase), record);
  }
  console.log(`${cases.length} cases, ${rounds} ${rounds === 1 ? 'round' : 'rounds'}.`);
  const end = minutes > 0 ? performance.now() + minutes * 60_000 : Infinity;
  let measured = 0;
  for (let round = 0; round < rounds; round++) {
    for (const benchCase of cases) {
      if (performance.now() > end) {
        console.log(`Stopped after ${minutes} minutes, in round ${round + 1}.`);
        return measured;
      }
      const record = records.get(caseKey(benchCase))?.builds[benchCase.build];
      if (!record || record.error !== null) continue;
      const result = await browser.measure(`${urls[benchCase.build]}${benchCase.query}`, options);
      record.error = result.error;
      if (result.measurement) {
        record.rounds.push(result.measurement);
        measured++;
      }
      const name = [caseKey(benchCase), ...(builds.length > 1 ? [`[${builds[benchCase.build].name}]`] : [])].join(' ');
      console.log(`${round + 1}/${rounds} ${name.padEnd(60)} ${progress(result)}`);
      write(options, { browser, builds, records: [...records.values()], round });
    }
  }
  return measured;
}

/** @param {import('./benchBrowser.mjs').CaseResult} result */
function progress({ measurement, error }) {
  if (!measurement) return `FAILED: ${error}`;
  const { gpu, cpu, frame, draws, programs, uploadBytes, firstMs } = measurement;
  const ms = (/** @type {number[] | null} */ times) => digits(times && median(times)).padStart(5);
  return frame
    ? `GPU ${ms(gpu)}  CPU ${ms(cpu)}  frame ${ms(frame)}  first ${digits(firstMs)}`
    : `${draws} draws, ${programs} programs, ${uploadBytes} bytes sent`;
}

/**
 * Writes all there is so far: a run that is cut off leaves what it has.
 *
 * @param {BenchOptions} options
 * @param {{ browser: BenchBrowser, builds: Build[], records: CaseRecord[], round: number }} state
 */
function write(options, { browser, builds, records, round }) {
  const rows = records.map(({ benchCase, builds }) => ({
    benchCase,
    outcomes: builds.map(
      (build) => build && { summary: build.rounds.length > 0 ? summarise(build.rounds) : null, error: build.error },
    ),
  }));
  const renderer = records.flatMap(({ builds }) => builds.flatMap((build) => build?.rounds ?? []))[0]?.renderer ?? '';
  const date = new Date().toISOString().slice(0, 16).replace('T', ' ');
  const names = builds.map(({ name }) => name);
  const heading = { date, builds: names, renderer, browser: browser.version, rounds: round + 1 };
  const commit = commitOf('HEAD');
  const cases = rows.map(({ benchCase, outcomes }, index) => {
    const { scene, technique, lights, size } = benchCase;
    const measured = outcomes.map((outcome, at) => outcome && { ...outcome, ...records[index].builds[at] });
    return { scene, technique, lights, size, builds: measured };
  });
  mkdirSync(options.out, { recursive: true });
  writeFileSync(join(options.out, 'bench.md'), benchTable(heading, rows));
  writeFileSync(join(options.out, 'bench.json'), JSON.stringify({ ...heading, commit, options, cases }, null, 1));
}
