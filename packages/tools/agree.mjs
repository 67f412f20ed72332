/**
 * `npm run agree`: draws the agreement suites (matrix, scenes, models, effects, shadows) by every technique against stock
 * three, in many browsers side by side, and prints a table. `npm run agree -- --help` lists the options.
 *
 * For a GPU host without a network: `npm run agree -- --pack DIR` here puts all that is needed into DIR; bring DIR there
 * and run `node packages/tools/agree.mjs --gpu` in it. The host needs Node and a Chromium (CHROMIUM_PATH).
 */
import { spawnSync } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { agreeHelp, agreeOptions } from './agreeOptions.mjs';
import { fetchModels } from './agreeModels.mjs';
import { root } from './root.mjs';
import { runTool } from './runTool.mjs';

/** File that --pack writes into its folder: such a folder holds everything, so it is neither installed nor built. */
const marker = join(root, 'agree-packed.json');

/** Contents of a packed folder: sources of the tests, built pages, and the packages that the tests need. */
const packed = [
  ...[
    'package.json',
    'packages/tsconfig.base.json',
    'packages/tools',
    'e2e',
    'apps/viewer/dist',
    'public/microshaders',
  ],
  'packages/renderer/src',
  'apps/editor/src/model/surfaces',
  ...['@playwright/test', 'playwright', 'playwright-core', 'pixelmatch', 'pngjs'].map((name) => `node_modules/${name}`),
];

try {
  const { values } = parseArgs({ options: agreeOptions });
  if (values.help) console.log(agreeHelp);
  else process.exitCode = await agree(values);
} catch (error) {
  console.error(error instanceof Error ? error.message : error);
  process.exitCode = 1;
}

/** @param {{ gpu?: boolean, workers?: string, models?: string, 'no-models'?: boolean, pack?: string, json?: string, only?: string, chance?: string, seed?: string }} options */
async function agree(options) {
  const isPacked = existsSync(marker);
  if (isPacked) {
    linkTools();
  } else {
    const { ensureInstalled } = await import('./ensureInstalled.mjs');
    ensureInstalled();
    const built = spawnSync(process.execPath, [join(root, 'packages/tools/build.mjs'), '--tests'], {
      stdio: 'inherit',
    });
    if (built.status !== 0) return 1;
  }
  const chance = wholeOf('chance', options.chance, 0);
  const models = chance > 0 ? null : await modelsOf(options, isPacked);
  if (options.pack) return pack(resolve(options.pack), models);
  const workers = wholeOf('workers', options.workers, Math.min(10, availableParallelism()));
  if (workers < 1) throw new Error(`--workers ${workers}: give a whole number above 0.`);
  const begin = performance.now();
  const code = runTool(
    '@playwright/test',
    'playwright',
    [
      ...[
        'test',
        '--config',
        'e2e/playwright.config.ts',
        `--workers=${workers}`,
        `e2e/render/${chance > 0 ? 'chance' : ''}`,
      ],
      ...['--reporter', join(root, 'e2e/support/AgreementReporter.ts')],
      ...[...(models ? ['e2e/models/'] : []), ...(options.only ? ['--grep', options.only] : [])],
    ],
    {
      FAROL_E2E: 'built',
      FAROL_TESTS: 'verify',
      ...(options.gpu ? { FAROL_GPU: '1' } : {}),
      ...(models ? { FAROL_MODELS: models } : {}),
      ...(chance > 0 ? { FAROL_CHANCE: `${chance}`, FAROL_CHANCE_SEED: `${wholeOf('seed', options.seed, 0)}` } : {}),
      ...(options.json ? { FAROL_AGREE_FILE: resolve(options.json) } : {}),
    },
  );
  console.log(
    `${workers} browsers, ${((performance.now() - begin) / 1000).toFixed(0)} s, ${options.gpu ? 'GPU' : 'software rasteriser'}`,
  );
  return code;
}

/**
 * @param {string} name - of an option
 * @param {string | undefined} value
 * @param {number} otherwise
 */
function wholeOf(name, value, otherwise) {
  const number = Number(value ?? otherwise);
  if (!Number.isInteger(number) || number < 0) throw new Error(`--${name} ${value}: give a whole number.`);
  return number;
}

/**
 * @param {{ models?: string, 'no-models'?: boolean }} options
 * @param {boolean} isPacked
 * @returns {Promise<string | null>} folder of the glTF models to draw; null to draw none
 */
async function modelsOf(options, isPacked) {
  if (options['no-models']) return null;
  if (options.models) return resolve(options.models);
  if (isPacked) return existsSync(join(root, 'models')) ? join(root, 'models') : null;
  return fetchModels(join(root, '.cache/agree-models'));
}

/** The tests import @farol/tools by a link, which not every way of copying keeps: a packed folder makes it when it runs. */
function linkTools() {
  const link = join(root, 'node_modules/@farol/tools');
  if (existsSync(link)) return;
  mkdirSync(join(root, 'node_modules/@farol'), { recursive: true });
  symlinkSync(join(root, 'packages/tools'), link, 'junction');
}

/** @param {string} to @param {string | null} models */
function pack(to, models) {
  rmSync(to, { recursive: true, force: true });
  mkdirSync(to, { recursive: true });
  for (const path of packed) cpSync(join(root, path), join(to, path), { recursive: true, dereference: true });
  if (models) cpSync(models, join(to, 'models'), { recursive: true });
  writeFileSync(join(to, 'agree-packed.json'), '{}\n');
  console.log(`${to}: bring it to the GPU host, and run node packages/tools/agree.mjs --gpu in it.`);
  return 0;
}
