/**
 * `npm run e2e -- shadows`: the browser tests whose file has this in its name, from source, with those of verify; further
 * arguments go to Playwright (`--headed`, `--trace on`, `-g title`). After `--long` with those of long, see extent.mjs.
 */
import { ensureBrowser } from './ensureBrowser.mjs';
import { ensureInstalled } from './ensureInstalled.mjs';
import { runTool } from './runTool.mjs';

const args = process.argv.slice(2).filter((each) => each !== '--long');
const usual = process.argv.includes('--long') ? 'long' : 'verify';
if (args.length === 0) {
  console.error('Name a spec or a folder of e2e/: npm run e2e -- shadows');
  process.exit(1);
}
ensureInstalled();
process.exit(
  runTool('@playwright/test', 'playwright', ['test', '--config', 'e2e/playwright.config.ts', ...args], {
    CHROMIUM_PATH: ensureBrowser(),
    FAROL_TESTS: process.env.FAROL_TESTS ?? usual,
  }),
);
