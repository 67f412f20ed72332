/**
 * Runs a browser suite at full length, which `npm test` runs a short form of.
 *
 * `npm run devices`: every technique and effect on every device of e2e/pages/devices.ts.
 * `npm run losses -- 20`: as many losses of the context by each technique and effect; 100 when no number is given.
 */
import { ensureBrowser } from './ensureBrowser.mjs';
import { ensureInstalled } from './ensureInstalled.mjs';
import { runTool } from './runTool.mjs';

/** @type {Record<string, { filter: string, variable: string, value: string }>} by name */
const suites = {
  devices: { filter: 'devices.spec.ts', variable: 'FAROL_DEVICES', value: 'all' },
  losses: { filter: 'losses.spec.ts', variable: 'FAROL_LOSSES', value: '100' },
};

const [name, value, ...rest] = process.argv.slice(2);
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
  { [suite.variable]: value ?? suite.value, CHROMIUM_PATH: ensureBrowser() },
);
process.exit(code);
