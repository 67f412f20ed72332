/**
 * `npm run bench`: measures a preset of the Lab headless, by the Lab's own code. `npm run bench -- --help` lists the
 * options. With `--dist` it needs Node and playwright-core alone.
 */
import {
  appendFileSync,
  cpSync,
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { join, resolve } from 'node:path';
import { buildLab, buildReference, isBuilt } from './benchBuild.mjs';
import { LabBrowser } from './benchLabBrowser.mjs';
import { remainingMinutes, runLine } from './benchLabWords.mjs';
import { benchHelp, parseBenchOptions } from './benchOptions.mjs';
import { serveFolder } from './benchServe.mjs';
import * as verdict from './benchVerdict.mjs';
import { ensureBrowser } from './ensureBrowser.mjs';
import { ensureInstalled } from './ensureInstalled.mjs';
import { root } from './root.mjs';

/**
 * @typedef {import('./benchOptions.mjs').BenchOptions} BenchOptions
 * @typedef {import('./benchLabBrowser.mjs').LabPlan} LabPlan
 * @typedef {import('./benchLabBrowser.mjs').LabRun} LabRun
 * @typedef {{ now: string, against: string | null }} Labs folders of built Labs
 */

/** Competitors measured for `--regret`: auto, the techniques that it may choose, and others that could be faster. */
const chosenByAuto = [
  ...['auto', 'forward-single-pass', 'clustered-forward', 'tiled-forward', 'forward-plus'],
  ...['deferred', 'clustered-deferred', 'tiled-deferred'],
];

/** Maximum number of starts of a browser in a run; each crash needs another one. */
const MOST_STARTS = 10;

/** Figures recorded in earlier runs on one machine: the table shows them beside those of this run. */
const REACHED = join(root, 'apps/lab/reached.json');

/**
 * @param {BenchOptions} options
 * @returns {Promise<number>} exit code: 0 when anything was measured and nothing is worse than its limit
 * @throws {Error} that names the option and the remedy
 */
async function bench(options) {
  const labs = await prepareLabs(options);
  if (options.buildOnly) return keepLabs(labs, options.out);
  /** @type {Record<string, string>} */
  const beside = labs.against === null ? {} : { against: labs.against };
  const server = await serveFolder(labs.now, { beside });
  const browser = new LabBrowser({ ...options, executablePath: ensureBrowser(), url: server.url });
  const end = options.minutes > 0 ? performance.now() + options.minutes * 60_000 : Infinity;
  try {
    const plan = await planFor(browser, options);
    const previous = options.resume ? await readPrevious(browser, plan, options.out) : null;
    const rest = previous === null ? plan : await browser.call((lab, run) => lab.remaining(run), previous);
    const measured =
      rest.series.length === 0 ? previous : await measure(browser, { plan, rest, previous, options, end });
    if (measured === null) return 1;
    const run = { ...measured, name: options.name ?? measured.name };
    await writeFiles(browser, run, options);
    if (options.reference !== null) keepReference(run, options.reference);
    const isMeasured = run.rows.some(({ frame }) => frame !== null);
    return isMeasured && (await judge(browser, run, options, end)) ? 0 : 1;
  } finally {
    await browser.close();
    await server.close();
  }
}

/** @param {BenchOptions} options @returns {Promise<Labs>} */
async function prepareLabs({ dist, against, rivals }) {
  let now;
  if (dist !== null) {
    now = resolve(dist);
    if (!isBuilt(now)) {
      throw new Error(`--dist ${dist}: no stage.html there; build the Lab with npm run build, and give apps/lab/dist.`);
    }
  } else {
    ensureInstalled();
    console.log('Building the Lab.');
    now = await buildLab(root);
  }
  if (rivals && !hasRivals(now)) {
    throw new Error('--rivals: the other engines are not in the build. Run npm run rivals, then build the Lab again.');
  }
  if (against === null) return { now, against: null };
  if (isBuilt(against)) return { now, against: resolve(against) };
  console.log(`Building the Lab of ${against}.`);
  return { now, against: await buildReference(against, join(root, '.cache/bench/against-lab')) };
}

/** @param {string} lab - folder */
function hasRivals(lab) {
  const path = join(lab, 'rivals/versions.json');
  return existsSync(path) && Object.keys(JSON.parse(readFileSync(path, 'utf8')).versions).length > 0;
}

/** @param {Labs} labs @param {string} out */
function keepLabs(labs, out) {
  for (const [name, folder] of Object.entries(labs)) {
    if (folder === null) continue;
    const to = join(out, name);
    rmSync(to, { recursive: true, force: true });
    cpSync(folder, to, { recursive: true, filter: (path) => !path.startsWith(join(folder, 'types')) });
    console.log(to);
  }
  return 0;
}

/**
 * @param {LabBrowser} browser @param {BenchOptions} options
 * @returns {Promise<LabPlan>}
 */
function planFor(browser, { fragment, regret, lights, rivals, against, gpu }) {
  return browser.call(
    (lab, { fragment, regret, lights, rivals, isCompared, gpu }) => {
      // what the large button of the Lab's page would measure
      const configuration =
        fragment === 'preset=quick' ? lab.quickFor({ software: !gpu }) : lab.configurationOf(fragment);
      if (lights) {
        configuration.series = configuration.series.map((/** @type {{ axis: string }} */ each) =>
          each.axis === 'lights' ? { ...each, values: lights } : each,
        );
      }
      if (regret) {
        const all = ['lights', 'objects', 'resolution', 'overdraw', 'shadows', 'matter'];
        const more = all.flatMap((name) => lab.configurationOf(`preset=${name}`).series);
        configuration.series = [...configuration.series, ...more];
        if (!new URLSearchParams(fragment).has('techniques')) configuration.competitors = regret;
      }
      const others = Object.keys(lab.competitors).filter((name) => lab.competitors[name].kind === 'rival');
      const named = [...new Set([...configuration.competitors, ...(rivals ? others : [])])];
      const plan = lab.planOf({ ...configuration, competitors: named });
      if (!isCompared) return plan;
      // the two builds of a technique take adjacent turns; only Farol's techniques are compared by build
      const competitors = named.flatMap((name) =>
        lab.competitors[name].kind === 'farol' ? [name, `${name}@against`] : [name],
      );
      return { ...plan, competitors };
    },
    { fragment, regret: regret && chosenByAuto, lights, rivals, isCompared: against !== null, gpu },
  );
}

/**
 * Reads the run that ended early, to continue it.
 *
 * @param {LabBrowser} browser @param {LabPlan} plan @param {string} out
 * @returns {Promise<LabRun | null>} null without one
 * @throws {Error} when it is a run of another plan, device, browser or build
 */
async function readPrevious(browser, plan, out) {
  const path = join(out, 'bench.json');
  if (!existsSync(path)) return null;
  const run = await browser.call((lab, json) => lab.parse(json), readFileSync(path, 'utf8'));
  const key = (/** @type {LabPlan} */ { series, competitors }) =>
    JSON.stringify([series.map(({ cases, name }) => [name, cases]), competitors]);
  if (key(run.plan) !== key(plan)) {
    throw new Error(`--resume: ${path} is a run of something else. Give another --out, or leave --resume out.`);
  }
  const here = await browser.call((lab) => lab.surroundings());
  for (const field of /** @type {const} */ (['device', 'browser', 'build'])) {
    const [then, now] = [run.surroundings[field], here[field]];
    if (then === now) continue;
    throw new Error(
      `--resume: the ${field} of ${path} is ${then}, here it is ${now}. Give another --out, or begin anew.`,
    );
  }
  return run;
}

/**
 * @param {LabBrowser} browser
 * @param {{ plan: LabPlan, rest: LabPlan, previous: LabRun | null, options: BenchOptions, end: number }} world - end: time
 *   at which it ends early (ms)
 * @returns {Promise<LabRun | null>} null when nothing was measured
 */
async function measure(browser, { plan, rest, previous, options, end }) {
  const { out, against } = options;
  const command = ['npm run bench --', ...process.argv.slice(2).map(quoted)].join(' ');
  /** @type {Record<string, string>} */
  const versions = against === null ? {} : { against };
  /** @type {LabRun[]} */
  let parts = previous === null ? [] : [previous];
  let whole = previous;
  const count = (/** @type {LabPlan} */ { series }) => series.reduce((sum, { cases }) => sum + cases.length, 0);
  console.log(`${count(rest)} of ${count(plan)} cases, ${plan.competitors.length} competitors in turns.`);
  /** @type {import('./benchLabBrowser.mjs').Crash[]} */
  const crashes = [];
  for (let start = 1; rest.series.length > 0; start++) {
    let printed = 0;
    /** @type {import('./benchLabBrowser.mjs').Step | null} */
    let at = null;
    /** @type {LabRun | null} */
    let part = null;
    const done = new Set();
    const onStep = (/** @type {import('./benchLabBrowser.mjs').Step} */ step) => {
      if (step.competitor !== null) at = step;
      if (performance.now() > end) void browser.cancel().catch(() => {});
      if (performance.now() - printed < 5000) return;
      printed = performance.now();
      console.log(`  ${step.done}/${step.total} ${step.competitor ?? ''}${remainingMinutes(step.remaining)}`);
    };
    const onCase = (/** @type {LabRun} */ run) => {
      part = run;
      printCases(run, done);
      void keepParts([...parts, run]).catch(() => {});
    };
    const keepParts = async (/** @type {LabRun[]} */ runs) => {
      whole = await browser.call((lab, { plan, runs }) => lab.merge(plan, runs), { plan, runs });
      writeRun(whole, options);
    };
    try {
      part = await browser.run(rest, { command, versions, crashes, onStep, onCase });
      printCases(part, done, true);
      await keepParts([...parts, part]);
      return whole;
    } catch (error) {
      const { competitor, labCase } = /** @type {import('./benchLabBrowser.mjs').Step} */ (at ?? {});
      console.error(`Stopped at ${competitor ?? 'its start'}: ${error instanceof Error ? error.message : error}.`);
      await browser.close();
      if (!competitor || start === MOST_STARTS || performance.now() > end) break;
      crashes.push({ competitor, labCase });
      console.log(`The browser is started anew, and ${competitor} is left out in that case.`);
      if (part !== null) await keepParts([...parts, part]);
      parts = whole === null ? [] : [whole];
      // `part`, the run as last given to `onCase`, holds complete cases alone
      rest =
        whole === null
          ? plan
          : await browser.call((lab, run) => lab.remaining(run), { ...whole, complete: part !== null });
    }
  }
  console.log(`${join(out, 'bench.json')} has what was measured; --resume goes on.`);
  return whole;
}

/** An argument, quoted for a shell if needed. @param {string} argument */
const quoted = (argument) => (/^[\w./:=,@+-]+$/.test(argument) ? argument : `'${argument.replaceAll("'", "'\\''")}'`);

/** Prints the cases that have ended. @param {LabRun} run @param {Set<string>} done @param {boolean} [isLast] */
function printCases({ plan, rows }, done, isLast = false) {
  for (const series of plan.series) {
    series.cases.forEach((_, index) => {
      const key = `${series.name} ${index}`;
      const caseRows = rows.filter((row) => row.series === series.name && row.index === index);
      if (done.has(key) || caseRows.length === 0 || (caseRows.length < plan.competitors.length && !isLast)) return;
      done.add(key);
      console.log(runLine(series, index, caseRows));
    });
  }
}

/** @param {LabRun} run @param {BenchOptions} options */
function writeRun(run, { out, name, withoutPictures }) {
  mkdirSync(out, { recursive: true });
  const rows = withoutPictures ? run.rows.map(withoutPicture) : run.rows;
  writeFileSync(join(out, 'bench.json'), `${JSON.stringify({ ...run, name: name ?? run.name, rows })}\n`);
}

/** @param {import('./benchLabBrowser.mjs').LabRow} row */
const withoutPicture = (row) => ({ ...row, likeness: row.likeness && { ...row.likeness, thumbnail: '' } });

/** Writes tables and drawings of the whole run. @param {LabBrowser} browser @param {LabRun} run @param {BenchOptions} options */
async function writeFiles(browser, run, options) {
  const { out } = options;
  writeRun(run, options);
  const files = await browser.call((lab, run) => lab.files(run), run);
  // removes drawings of an earlier run
  for (const name of readdirSync(out)) if (name.endsWith('.svg')) rmSync(join(out, name));
  for (const { name, text } of files) writeFileSync(join(out, name), text);
  const drawings = files.filter(({ name }) => name.endsWith('.svg')).length;
  const early = run.complete ? '' : ' The run ended early; --resume goes on with it.';
  console.log(
    `\n${join(out, 'bench.md')}, bench.json and ${drawings} ${drawings === 1 ? 'drawing' : 'drawings'}.${early}`,
  );
}

/**
 * Prints a run's table, the cases slower than in the other build, and the losses of `auto`.
 *
 * @param {LabBrowser} browser @param {LabRun} run @param {BenchOptions} options
 * @param {number} end - time from which on nothing is measured again (ms)
 * @returns {Promise<boolean>} whether nothing is worse than its limit
 */
async function judge(browser, run, options, end) {
  /** @type {import('./benchVerdict.mjs').Reached | null} */
  const reached = existsSync(REACHED) ? JSON.parse(readFileSync(REACHED, 'utf8')) : null;
  const table = verdict.figuresTable(run, reached);
  const regret = options.regret ? verdict.regretReport(run) : null;
  appendFileSync(join(options.out, 'bench.md'), `\n## Figures\n\n${table}\n`);
  console.log(`\n${regret?.text ?? table}`);
  if (options.write) writeFileSync(REACHED, verdict.reachedText(run, reached));
  if (!run.complete) return true;
  let slower = verdict.slowerCases(run);
  if (slower.length > 0 && performance.now() < end) {
    console.log(`\nSlower in ${slower.length} figures: these cases once more, in twice as many turns.`);
    const plan = verdict.doubtfulPlan(run.plan, slower);
    const again = { ...options, out: join(options.out, 'again') };
    const second = await measure(browser, { plan, rest: plan, previous: null, options: again, end });
    const key = (/** @type {import('./benchVerdict.mjs').Slower} */ { name, competitor, what }) =>
      `${name} ${competitor} ${what}`;
    const first = new Set(slower.map(key));
    if (second?.complete) slower = verdict.slowerCases(second).filter((each) => first.has(key(each)));
    if (slower.length === 0) console.log('Not slower the second time.');
  }
  for (const { name, competitor, what, ratio } of slower)
    console.log(`SLOWER: ${name}, ${competitor}: ${what} ${ratio.toFixed(3)} of the other build's`);
  return slower.length === 0 && (regret?.isWithin ?? true);
}

/** @param {LabRun} run @param {string} name */
function keepReference(run, name) {
  const file = `apps/lab/reference/${name}.json`;
  const path = join(root, file);
  if (!run.complete) {
    console.log(`${file} is written once every case is measured: give the same command again.`);
    return;
  }
  mkdirSync(join(path, '..'), { recursive: true });
  writeFileSync(path, `${JSON.stringify({ ...run, name: run.name || name, rows: run.rows.map(withoutPicture) })}\n`);
  console.log(file);
}

try {
  const options = parseBenchOptions(process.argv.slice(2));
  if (options.help) console.log(benchHelp);
  else process.exitCode = await bench(options);
} catch (error) {
  console.error(error instanceof Error ? error.message : error);
  process.exitCode = 1;
}
