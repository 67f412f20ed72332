/**
 * Runs the browser tests of one subject at full length, which `npm test` runs a slice of.
 *
 * `npm run devices`: every technique and effect on every device of e2e/pages/devices.ts.
 * `npm run losses`: a hundred losses of the context by each technique and effect, in the editor and in an attached page.
 */
import { ensureBrowser } from './ensureBrowser.mjs';
import { ensureInstalled } from './ensureInstalled.mjs';
import { runTool } from './runTool.mjs';

/** @type {Record<string, { filter: string, extent: import('./extent.mjs').Extent }>} by name */
const suites = {
  devices: { filter: 'devices.spec.ts', extent: 'verify' },
  losses: { filter: 'losses.spec.ts', extent: 'long' },
};

const [name, ...rest] = process.argv.slice(2);
const suite = suites[name];
if (!suite) {
  console.error(`No suite ${name}: the suites are ${Object.keys(suites).join(', ')}.`);
  process.exit(1);
}
ensureInstalled();
const code = runTool(
  '@playwright/test',
  'playwright',
  ['test', '--config', 'e2e/playwright.config.ts', suite.filter, ...rest],
  { FAROL_TESTS: suite.extent, CHROMIUM_PATH: ensureBrowser() },
);
process.exit(code);
