import { findOtherBrowsers } from '@farol/tools/findOtherBrowsers';
import { defineConfig } from '@playwright/test';

/** Tests in other browsers than Chromium, by WebDriver: `npm run browsers`. */
const { firefox, webkit } = findOtherBrowsers();

export default defineConfig({
  testDir: '.',
  globalSetup: './globalSetup.ts',
  outputDir: process.env.FAROL_TEST_OUTPUT ?? '../../.cache/other-browser-tests',
  workers: 1,
  retries: 0,
  timeout: 600_000,
  expect: { timeout: 60_000 },
  reporter: [['list'], ['./BrowsersReporter.ts']],
  projects: [...(firefox ? [{ name: 'firefox' }] : []), ...(webkit ? [{ name: 'webkit' }] : [])],
});
