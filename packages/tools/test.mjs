/**
 * `npm test`: installs what is missing, then every check in turn; stops at the first stage that fails. The last line is
 * `N passed, N failed`, over unit and browser tests; a stage that fails without a failed test counts as one.
 *
 * `node packages/tools/test.mjs types lint` runs the named stages only.
 */
import { mkdirSync, readFileSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { ensureBrowser } from './ensureBrowser.mjs';
import { ensureInstalled } from './ensureInstalled.mjs';
import { root } from './root.mjs';
import { runTool } from './runTool.mjs';
import { startTool } from './startTool.mjs';
import { addTallies, playwrightTally, tallyLine, vitestTally } from './tally.mjs';
import { spawnSync } from 'node:child_process';

const reports = join(root, '.cache/test');
/** @type {import('./tally.mjs').Tally} */
let tally = { passed: 0, failed: 0 };

/** @type {Record<string, () => boolean | Promise<boolean>>} name to work; true when all is well */
const stages = {
  types: () => runTool('typescript', 'tsc', ['-b', 'packages']) === 0,
  lint: async () => runTool('oxlint', 'oxlint', []) === 0 && (await isFormatted(['packages'], ['.', '!packages/**'])),
  unit: () =>
    counted('unit.json', vitestTally, (report) =>
      runTool('vitest', 'vitest', [
        ...['run', '--config', 'packages/vitest.config.ts'],
        ...['--reporter=default', '--reporter=json', `--outputFile.json=${report}`],
      ]),
    ),
  build: () =>
    spawnSync(process.execPath, [join(root, 'packages/tools/build.mjs'), '--tests'], { stdio: 'inherit' }).status === 0,
  packages: () => playwright('packages', 'e2e/packages/playwright.config.ts'),
  browser: () => playwright('browser', 'e2e/playwright.config.ts', { FAROL_E2E: 'built' }),
};

const asked = process.argv.slice(2);
const unknown = asked.filter((name) => !(name in stages));
if (unknown.length > 0) {
  console.error(`No stage ${unknown.join(', ')}: the stages are ${Object.keys(stages).join(', ')}.`);
  process.exit(1);
}

ensureInstalled();
mkdirSync(reports, { recursive: true });
let failedStage = '';
for (const name of asked.length > 0 ? asked : Object.keys(stages)) {
  const begin = performance.now();
  console.log(`\n== ${name}`);
  const failedBefore = tally.failed;
  if (!(await attempt(stages[name]))) {
    failedStage = name;
    if (tally.failed === failedBefore) tally.failed++;
    break;
  }
  console.log(`${name} done in ${((performance.now() - begin) / 1000).toFixed(1)} s`);
}
if (failedStage) console.log(`\nStage ${failedStage} failed.`);
if (failedStage || tally.passed > 0) console.log(tallyLine(tally));
process.exit(failedStage ? 1 : 0);

/** Prettier uses one core: it checks parts of the tree side by side. @param {string[][]} parts patterns of each */
async function isFormatted(...parts) {
  const check = ['--check', '--log-level', 'warn'];
  const codes = await Promise.all(parts.map((part) => startTool('prettier', 'prettier', [...check, ...part])));
  return codes.every((code) => code === 0);
}

/**
 * Runs tests of Playwright's.
 *
 * @param {string} name of the stage
 * @param {string} config
 * @param {Record<string, string>} [env]
 */
function playwright(name, config, env = {}) {
  const chromium = ensureBrowser();
  return counted(`${name}.json`, playwrightTally, (report) =>
    runTool('@playwright/test', 'playwright', ['test', '--config', config], {
      ...env,
      PLAYWRIGHT_JSON_OUTPUT_NAME: report,
      CHROMIUM_PATH: chromium,
    }),
  );
}

/** @param {() => boolean | Promise<boolean>} stage */
async function attempt(stage) {
  try {
    return await stage();
  } catch (error) {
    console.error(error instanceof Error ? error.message : error);
    return false;
  }
}

/**
 * Runs a test runner that writes a JSON report, and adds its counts.
 *
 * @param {string} file
 * @param {(report: any) => import('./tally.mjs').Tally} count
 * @param {(path: string) => number} run gives the exit code
 */
function counted(file, count, run) {
  const path = join(reports, file);
  rmSync(path, { force: true });
  const code = run(path);
  const counts = count(JSON.parse(readFileSync(path, 'utf8')));
  tally = addTallies(tally, counts);
  return code === 0 && counts.failed === 0;
}
