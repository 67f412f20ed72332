import { readdirSync, readFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import { byExtent, isWhole } from '@farol/tools/extent';
import { findBrowser } from '@farol/tools/findBrowser';
import { gpuFlags, softwareFlags } from '@farol/tools/browserFlags';
import { defineConfig } from '@playwright/test';

/**
 * Browser tests. The servers start in support/globalSetup.ts on free ports, from source, or from the built apps with
 * FAROL_E2E=built (as `npm test` does). FAROL_GPU=1 leaves the software rasteriser out. How much of the tests runs is said
 * by FAROL_TESTS and the tags in titles: see README.md beside this file.
 *
 * A browser keeps the shaders that it has compiled, and another project has another browser: one project for all folders in
 * verify, in the slice two. Which app `page.goto('./')` opens goes by the folder: see support/test.ts.
 */
const browser = findBrowser();
if (!browser) throw new Error('No Chromium found: run npm test once, which installs one, or set CHROMIUM_PATH.');
const gpu = Boolean(process.env.FAROL_GPU);

/** Tags of the tests that this run leaves out. */
const leftOut = [...byExtent({ slice: ['@verify', '@long'], verify: ['@long'], long: [] }), gpu ? '@software' : '@gpu'];

/** Folders that other commands run. */
const elsewhere = [
  'packages/**', // by a configuration of its own
  'browsers/**', // by `npm run browsers`, in Firefox and WebKit
  ...(process.env.FAROL_MODELS ? [] : ['models/**']), // by `npm run agree`: glTF models of a folder
  ...(process.env.FAROL_RIVALS ? [] : ['rivals/**']), // by `npm run rivals -- --check`, which installs them
];

const workers = Math.max(2, availableParallelism() - 2);
/** Files whose tests draw in one page: see support/benchTest.ts. */
const benches = readdirSync(import.meta.dirname, { recursive: true, encoding: 'utf8' })
  .filter((name) => name.endsWith('.spec.ts'))
  .map((name) => join(import.meta.dirname, name))
  .filter((path) => readFileSync(path, 'utf8').includes("/benchTest'"));

export default defineConfig({
  testDir: '.',
  testMatch: '**/*.spec.ts',
  testIgnore: elsewhere,
  grepInvert: new RegExp(leftOut.map((tag) => `${tag}\\b`).join('|')),
  globalSetup: './support/globalSetup.ts',
  outputDir: process.env.FAROL_TEST_OUTPUT ?? '../.cache/browser-tests',
  workers,
  // in the slice tests of a file share a worker: another browser would compile their shaders anew
  fullyParallel: isWhole,
  retries: 0,
  forbidOnly: Boolean(process.env.CI),
  timeout: isWhole ? 480_000 : 240_000,
  expect: { timeout: 30_000 },
  reporter: [
    ['list'],
    ['./support/AssertionReporter.ts'],
    ...(process.env.PLAYWRIGHT_JSON_OUTPUT_NAME ? [['json'] as const] : []),
  ],
  // half of the browsers compile the shaders of Benches, which the others need not; they help with what is left
  ...(!isWhole && {
    projects: [
      { name: 'benches', testMatch: benches, workers: Math.ceil(workers / 2) },
      { name: 'others', testIgnore: [...elsewhere, ...benches] },
    ],
  }),
  use: {
    viewport: { width: 640, height: 360 },
    // an element that never comes fails its test, which names it, in place of holding a browser until the test's time is over
    actionTimeout: 90_000,
    // each context would fetch a whole built app; offline.spec.ts lets them be
    serviceWorkers: 'block',
    trace: 'off',
    video: 'off',
    screenshot: 'only-on-failure',
    launchOptions: {
      executablePath: browser.path,
      args: [...(gpu ? gpuFlags : softwareFlags)],
    },
  },
});
