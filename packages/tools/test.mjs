/**
 * `npm test`: installs what is missing, then checks a slice of everything. `npm run verify`: all of it, by all cores of the
 * machine. See e2e/README.md for what is in which.
 *
 * `node packages/tools/test.mjs types lint` runs the named stages only. A stage that fails does not end the others, and a
 * test that fails is run once more, alone: what passes then is listed as flaky. The last line is `N passed, N failed`, over
 * unit and browser tests; a stage that fails without a failed test counts as one.
 */
import { existsSync, readFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join, relative } from 'node:path';
import { parseArgs } from 'node:util';
import { ensureBrowser } from './ensureBrowser.mjs';
import { ensureInstalled } from './ensureInstalled.mjs';
import { failedPlaywrightTests, failedVitestTests } from './failedTests.mjs';
import { findBrowser } from './findBrowser.mjs';
import { root } from './root.mjs';
import { copyBuilt, makeRunFolder, whileNobodyBuilds } from './runFolder.mjs';
import { runStages } from './runStages.mjs';
import { stagePlan } from './stagePlan.mjs';
import { endWithScripts, startScript, startTool } from './startTool.mjs';
import { addTallies, playwrightTally, tallyLine, vitestTally } from './tally.mjs';

/** Maximum number of failed tests that are run once more: more failures than that are not due to chance. */
const MOST_AGAIN = 20;

const { values, positionals } = parseArgs({
  options: { verify: { type: 'boolean', default: false }, gpu: { type: 'boolean', default: false } },
  allowPositionals: true,
});
if (values.verify) process.env.FAROL_TESTS = 'verify';
if (values.gpu) process.env.FAROL_GPU = '1';

const isSmall = availableParallelism() < 6;
/** Option of stages that run beside others: their output is shown in one piece. */
const held = { isHeld: true };

/** @type {Record<keyof typeof stagePlan, () => Promise<boolean>>} */
const runs = {
  chromium: async () => findBrowser() !== null || (await startScript(tool('ensureBrowser.mjs'), [], held)) === 0,
  types: async () => (await startTool('typescript', 'tsc', ['-b', 'packages'], held)) === 0,
  lint: async () =>
    (await startTool('oxlint', 'oxlint', [], held)) + (await startTool('oxfmt', 'oxfmt', ['--check'], held)) === 0,
  unit: () => vitest(),
  build: () =>
    whileNobodyBuilds(
      async () =>
        (await startScript(tool('build.mjs'), values.verify ? ['--tests', '--site'] : ['--tests'], held)) === 0,
    ),
  packages: () => whileNobodyBuilds(() => playwright('packages', 'e2e/packages/playwright.config.ts')),
  browser: () =>
    playwright('browser', 'e2e/playwright.config.ts', { FAROL_E2E: 'built', FAROL_BUILT: copyBuilt(folder) }),
};
/** @type {Record<string, import('./runStages.mjs').Stage>} */
const stages = Object.fromEntries(
  Object.entries(stagePlan).map(([name, stage]) => [
    name,
    { ...stage, run: runs[/** @type {keyof typeof stagePlan} */ (name)] },
  ]),
);

const unknown = positionals.filter((name) => !(name in stages));
if (unknown.length > 0) {
  console.error(`No stage ${unknown.join(', ')}: the stages are ${Object.keys(stages).join(', ')}.`);
  process.exit(1);
}

ensureInstalled();
endWithScripts();
const folder = makeRunFolder();
/** @type {import('./tally.mjs').Tally} */
let tally = { passed: 0, failed: 0 };
/** @type {string[]} */
const flaky = [];
/** @type {string[]} */
const red = [];
/** @type {Record<string, number>} */
const begun = {};
const asked = Object.entries(stages).filter(([name]) => positionals.length === 0 || positionals.includes(name));
const outcomes = await runStages(Object.fromEntries(asked), {
  isSmall,
  onStart: (name) => {
    begun[name] = performance.now();
    console.log(`\n== ${name}`);
  },
  onEnd: (name, outcome) => {
    const seconds = ((performance.now() - (begun[name] ?? performance.now())) / 1000).toFixed(1);
    console.log(`${name} ${outcome}${outcome === 'left out' ? '' : ` in ${seconds} s`}`);
  },
});
const failedStages = Object.entries(outcomes).filter(([, outcome]) => outcome !== 'passed');
if (red.length > 0) console.log(`\nFailed:\n  ${red.join('\n  ')}`);
if (flaky.length > 0) console.log(`\nFlaky (failed, and passed when run once more alone):\n  ${flaky.join('\n  ')}`);
if (failedStages.length > 0) {
  console.log(`\n${failedStages.map(([name, outcome]) => `Stage ${name}: ${outcome}.`).join('\n')}`);
  console.log(`Reports and traces: ${relative(root, folder)}`);
  tally.failed = Math.max(tally.failed, 1);
}
if (failedStages.length > 0 || tally.passed > 0) console.log(tallyLine(tally));
process.exit(failedStages.length > 0 ? 1 : 0);

/** @param {string} name - of a script of this folder */
function tool(name) {
  return join(root, 'packages/tools', name);
}

async function vitest() {
  const runOf = (/** @type {string} */ name) => (/** @type {string[]} */ files) => {
    const report = join(folder, name);
    const reporters = ['--reporter=default', '--reporter=json', `--outputFile.json=${report}`];
    const args = ['run', '--config', 'packages/vitest.config.ts', ...reporters, ...files];
    return counted(report, () => startTool('vitest', 'vitest', args, held));
  };
  return twice(runOf('unit.json'), runOf('unit-again.json'), {
    failedOf: (report) => failedVitestTests(report, root),
    tallyOf: vitestTally,
  });
}

/**
 * Runs tests of Playwright's.
 *
 * @param {'packages' | 'browser'} name - of the stage
 * @param {string} config
 * @param {Record<string, string>} [env]
 */
async function playwright(name, config, env = {}) {
  const chromium = ensureBrowser();
  const isHeld = !isSmall || !('alone' in stagePlan[name]);
  const runOf = (/** @type {string} */ name, /** @type {string[]} */ options) => (/** @type {string[]} */ places) => {
    const report = join(folder, `${name}.json`);
    const added = {
      ...env,
      PLAYWRIGHT_JSON_OUTPUT_NAME: report,
      FAROL_TEST_OUTPUT: join(folder, name),
      CHROMIUM_PATH: chromium,
    };
    const args = ['test', '--config', config, ...options, ...places];
    return counted(report, () => startTool('@playwright/test', 'playwright', args, { env: added, isHeld }));
  };
  return twice(runOf(name, []), runOf(`${name}-again`, ['--workers=1', '--trace=on']), {
    failedOf: failedPlaywrightTests,
    tallyOf: playwrightTally,
  });
}

/**
 * Runs tests, those that fail once more, and adds up.
 *
 * @param {(places: string[]) => Promise<Counted>} run
 * @param {(places: string[]) => Promise<Counted>} again
 * @param {{ failedOf: (report: any) => { title: string, place: string }[], tallyOf: (report: any) => import('./tally.mjs').Tally }} reading
 * @returns {Promise<boolean>} whether all passed, at last
 */
async function twice(run, again, { failedOf, tallyOf }) {
  const first = await run([]);
  const counts = tallyOf(first.report);
  tally = addTallies(tally, counts);
  const failed = failedOf(first.report);
  if (first.code === 0 && counts.failed === 0) return true;
  const places = [...new Set(failed.map(({ place }) => place))];
  if (failed.length === 0 || failed.length < counts.failed || places.length > MOST_AGAIN) {
    red.push(...failed.map(({ title }) => title));
    if (counts.failed === 0) tally.failed++;
    return false;
  }
  console.log(`\n== once more, alone: ${places.join(', ')}`);
  const second = await again(places);
  const stillFailed = new Set(failedOf(second.report).map(({ title }) => title));
  const passed = second.code === 0 ? failed : failed.filter(({ title }) => !stillFailed.has(title));
  red.push(...failed.filter((test) => !passed.includes(test)).map(({ title }) => title));
  flaky.push(...passed.map(({ title }) => title));
  tally = addTallies(tally, { passed: passed.length, failed: -passed.length });
  return passed.length === failed.length;
}

/**
 * @typedef {{ code: number, report: any }} Counted
 *
 * @param {string} path - of the JSON report that the run writes
 * @param {() => Promise<number>} run - gives the exit code
 * @returns {Promise<Counted>}
 * @throws {Error} when there is no report, since the runner ended before
 */
async function counted(path, run) {
  const code = await run();
  if (!existsSync(path)) throw new Error(`The tests ended without a report (exit code ${code}): see above.`);
  return { code, report: JSON.parse(readFileSync(path, 'utf8')) };
}
