/**
 * `npm run compat`: draws the agreement matrix by one build of the packages with each minor of three that
 * `peerDependencies` allow, against the stock renderer of that same three, and prints a table.
 * `npm run compat -- --help` lists the options.
 */
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { compatHelp, compatOptions, threeVersions, typesOfThree } from './compatOptions.mjs';
import { compatRow, compatTable } from './compatTable.mjs';
import { ensureBrowser } from './ensureBrowser.mjs';
import { ensureInstalled } from './ensureInstalled.mjs';
import { otherThree } from './otherThree.mjs';
import { root } from './root.mjs';
import { runTool } from './runTool.mjs';

const cache = join(root, '.cache/compat');

const { values, positionals } = parseArgs({ options: compatOptions, allowPositionals: true });
if (values.help) {
  console.log(compatHelp);
  process.exit(0);
}
const versions = positionals.length > 0 ? positionals : threeVersions;
ensureInstalled();
if (!values.built) {
  const packages = spawnSync(process.execPath, [join(root, 'packages/tools/build.mjs')], { stdio: 'inherit' });
  if (packages.status !== 0) process.exit(1);
}
const rows = [];
for (const version of versions) rows.push(await draw(version));
console.log(`\n${compatTable(rows)}`);
process.exit(rows.every(({ failed, largest }) => failed === 0 && largest > 0) ? 0 : 1);

/** @param {string} version - of three */
async function draw(version) {
  const folder = join(cache, version);
  console.log(`\n== three ${version}`);
  install(version, folder);
  const units = runTool('vitest', 'vitest', ['run', '--config', 'packages/vitest.config.ts', 'packages/renderer/src'], {
    FAROL_THREE: folder,
  });
  await build(folder);
  const file = join(folder, 'comparisons.jsonl');
  const workers = Number(values.workers ?? Math.min(10, availableParallelism()));
  const code = runTool(
    '@playwright/test',
    'playwright',
    [
      ...['test', '--config', 'e2e/playwright.config.ts', `--workers=${workers}`],
      ...['--reporter', join(root, 'e2e/support/AgreementReporter.ts')],
      ...(values.all ? ['e2e/render/'] : ['render/agreement.spec.ts', 'render/matrix.spec.ts']),
      ...(values.only ? ['--grep', values.only] : []),
    ],
    {
      FAROL_E2E: 'built',
      FAROL_BUILT: folder,
      FAROL_TESTS: 'verify',
      FAROL_AGREE_FILE: file,
      CHROMIUM_PATH: ensureBrowser(),
      ...(values.gpu ? { FAROL_GPU: '1' } : {}),
    },
  );
  const types = runTool(
    '@playwright/test',
    'playwright',
    ['test', '--config', 'e2e/packages/playwright.config.ts', 'types.spec.ts', '--grep', 'other types of three'],
    {
      FAROL_TESTS: 'verify',
      FAROL_TYPES: join(folder, 'node_modules/@types/three'),
      CHROMIUM_PATH: ensureBrowser(),
    },
  );
  const passed = { tests: code === 0, units: units === 0, types: types === 0 };
  return compatRow(version, readFileSync(file, 'utf8'), passed);
}

/** @param {string} version @param {string} folder */
function install(version, folder) {
  const types = typesOfThree[/** @type {keyof typeof typesOfThree} */ (version)] ?? version;
  const is = (/** @type {string} */ name, /** @type {string} */ asked) => {
    const manifest = join(folder, 'node_modules', name, 'package.json');
    return existsSync(manifest) && JSON.parse(readFileSync(manifest, 'utf8')).version === asked;
  };
  if (is('three', version) && is('@types/three', types)) return;
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  writeFileSync(join(folder, 'package.json'), '{ "private": true }\n');
  const npm = process.platform === 'win32' ? 'npm.cmd' : 'npm';
  const packages = [`three@${version}`, `@types/three@${types}`];
  const done = spawnSync(npm, ['install', '--no-audit', '--no-fund', '--silent', ...packages], {
    cwd: folder,
    stdio: 'inherit',
  });
  if (done.status !== 0) throw new Error(`npm install ${packages.join(' ')} failed: see its message above.`);
}

/** The viewer and the tests' pages, with the packages' own dist and the three of a folder. @param {string} folder */
async function build(folder) {
  const { build: bundle } = await import('vite');
  for (const [name, source] of [
    ['viewer', 'apps/viewer'],
    ['pages', 'e2e/pages'],
  ]) {
    await bundle({
      root: join(root, source),
      configFile: join(root, source, 'vite.config.ts'),
      logLevel: 'error',
      plugins: [otherThree(folder)],
      build: { outDir: join(folder, name), emptyOutDir: true },
    });
    console.log(`built ${source} with ${folder.slice(cache.length + 1)}`);
  }
}
