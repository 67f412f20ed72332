import { findBrowser } from '@farol/tools/findBrowser';
import { gpuFlags, softwareFlags } from '@farol/tools/browserFlags';
import { isWhole } from '@farol/tools/extent';
import { defineConfig } from '@playwright/test';

/** Tests of the packages as a stranger gets them: packed, and installed into a folder beside three alone. */
const browser = findBrowser();
if (!browser) throw new Error('No Chromium found: run npm test once, which installs one, or set CHROMIUM_PATH.');

export default defineConfig({
  testDir: '.',
  ...(!isWhole && { grepInvert: /@verify\b/ }),
  globalSetup: './installPackages.ts',
  outputDir: process.env.FAROL_TEST_OUTPUT ?? '../../.cache/package-tests',
  workers: 2,
  fullyParallel: true,
  retries: 0,
  forbidOnly: Boolean(process.env.CI),
  timeout: 120_000,
  reporter: process.env.PLAYWRIGHT_JSON_OUTPUT_NAME ? [['list'], ['json']] : [['list']],
  use: {
    viewport: { width: 640, height: 360 },
    trace: 'off',
    video: 'off',
    launchOptions: { executablePath: browser.path, args: [...(process.env.FAROL_GPU ? gpuFlags : softwareFlags)] },
  },
});
