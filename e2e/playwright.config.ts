import { findBrowser } from '@farol/tools/findBrowser';
import { gpuFlags, softwareFlags } from '@farol/tools/browserFlags';
import { defineConfig } from '@playwright/test';

/**
 * Browser tests. The servers start in support/globalSetup.ts on free ports, from source, or from the built apps with
 * FAROL_E2E=built (as `npm test` does). FAROL_GPU=1 leaves the software rasteriser out.
 *
 * A page of the project `editor` resolves `page.goto('./')` to the editor, of `lab` to the Lab, of the others to
 * the viewer.
 */
const browser = findBrowser();
if (!browser) throw new Error('No Chromium found: run npm test once, which installs one, or set CHROMIUM_PATH.');

export default defineConfig({
  testDir: '.',
  globalSetup: './support/globalSetup.ts',
  outputDir: '../.cache/browser-tests',
  workers: 2,
  fullyParallel: true,
  retries: 0,
  forbidOnly: Boolean(process.env.CI),
  timeout: 240_000,
  expect: { timeout: 30_000 },
  reporter: process.env.PLAYWRIGHT_JSON_OUTPUT_NAME ? [['list'], ['json']] : [['list']],
  use: {
    viewport: { width: 640, height: 360 },
    trace: 'off',
    video: 'off',
    screenshot: 'only-on-failure',
    launchOptions: {
      executablePath: browser.path,
      args: [...(process.env.FAROL_GPU ? gpuFlags : softwareFlags)],
    },
  },
  projects: [
    { name: 'viewer', testDir: './viewer', use: { baseURL: process.env.FAROL_VIEWER_URL } },
    {
      name: 'render',
      testDir: './render',
      // its figures are of smoothness, against sample positions of the software rasteriser: no agreement with stock three
      testIgnore: process.env.FAROL_AGREE ? ['**/antialiasing.spec.ts'] : [],
      use: { baseURL: process.env.FAROL_VIEWER_URL },
    },
    {
      name: 'lab',
      testDir: './lab',
      use: { baseURL: process.env.FAROL_LAB_URL, viewport: { width: 1280, height: 720 } },
    },
    { name: 'examples', testDir: './examples', use: { baseURL: process.env.FAROL_VIEWER_URL } },
    { name: 'perf', testDir: './perf', use: { baseURL: process.env.FAROL_VIEWER_URL } },
    // by hand only: glTF models of a folder of yours
    ...(process.env.FAROL_MODELS
      ? [{ name: 'models', testDir: './models', use: { baseURL: process.env.FAROL_VIEWER_URL } }]
      : []),
    // by `npm run rivals -- --check` only, which installs them
    ...(process.env.FAROL_RIVALS
      ? [{ name: 'rivals', testDir: './rivals', use: { baseURL: process.env.FAROL_LAB_URL } }]
      : []),
    {
      name: 'editor',
      testDir: './editor',
      use: { baseURL: process.env.FAROL_EDITOR_URL, viewport: { width: 1280, height: 720 } },
    },
  ],
});
