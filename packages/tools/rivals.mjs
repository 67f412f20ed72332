/**
 * `npm run rivals`: installs the engines that the Lab measures beside Farol, PlayCanvas and Babylon.js, into a folder of
 * their own, and bundles each into one module that the Lab fetches when it is chosen. `npm ci` never installs them.
 *
 * `npm run rivals -- --check` checks the types of their code and compares their pictures with stock three's.
 */
import { bundleRivals, installRivals } from './buildRivals.mjs';
import { ensureBrowser } from './ensureBrowser.mjs';
import { ensureInstalled } from './ensureInstalled.mjs';
import { runTool } from './runTool.mjs';

const help = `npm run rivals [-- options]: installs PlayCanvas and Babylon.js for the Lab, and bundles them

  --check   also checks the types of their code, and compares their pictures with stock three's (minutes)
  --help    this`;

const asked = process.argv.slice(2);
const unknown = asked.filter((argument) => !['--check', '--help'].includes(argument));
if (unknown.length > 0 || asked.includes('--help')) {
  if (unknown.length > 0) console.error(`No option ${unknown.join(' ')}.\n`);
  console.log(help);
  process.exit(unknown.length > 0 ? 1 : 0);
}
ensureInstalled();
try {
  installRivals();
  for (const [name, { version, bytes }] of Object.entries(await bundleRivals())) {
    console.log(`${name} ${version}: ${(bytes / 1e6).toFixed(1)} MB`);
  }
} catch (error) {
  console.error(error instanceof Error ? error.message : error);
  process.exit(1);
}
if (asked.includes('--check')) {
  if (runTool('typescript', 'tsc', ['-p', 'apps/lab/rivals']) !== 0) process.exit(1);
  const args = ['test', '--config', 'e2e/playwright.config.ts', 'e2e/rivals/', '--workers', '1'];
  const env = { FAROL_RIVALS: '1', CHROMIUM_PATH: ensureBrowser() };
  process.exit(runTool('@playwright/test', 'playwright', args, env));
}
