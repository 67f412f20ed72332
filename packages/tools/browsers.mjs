/**
 * `npm run browsers`: draws the matrix against stock three, and uses the editor and an exported page, in Firefox and in WebKit
 * as far as they are installed, and prints a table. `npm run browsers -- --help` lists the options.
 */
import { parseArgs } from 'node:util';
import { ensureInstalled } from './ensureInstalled.mjs';
import { findOtherBrowsers } from './findOtherBrowsers.mjs';
import { runTool } from './runTool.mjs';

const help = `npm run browsers -- [options] [files]

Draws the matrix by four techniques against stock three of the same browser, and goes through the apps and an exported page,
in Firefox and WebKit by WebDriver, from source. Installs nothing.

  --all             the matrix by all techniques, and its settings
  --only firefox    one browser: firefox or webkit
  --grep TEXT       the tests whose title matches this regular expression
  --gpu             take the GPU of this machine, not the software rasteriser
  --help            this text`;

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    all: { type: 'boolean' },
    only: { type: 'string' },
    grep: { type: 'string' },
    gpu: { type: 'boolean' },
    help: { type: 'boolean' },
  },
});
if (values.help) console.log(help);
else process.exitCode = run();

/** @returns {number} exit code */
function run() {
  const { firefox, webkit, xvfb, missing } = findOtherBrowsers();
  if (firefox) console.log(`Firefox: ${firefox}`);
  if (webkit) console.log(`WebKit: ${webkit.browser}, by ${webkit.driver}`);
  if (xvfb) console.log(`Screen in memory: ${xvfb}`);
  for (const line of missing) console.log(line);
  if (!firefox && !webkit) {
    console.log('Nothing to run in.');
    return 1;
  }
  ensureInstalled();
  return runTool(
    '@playwright/test',
    'playwright',
    [
      ...['test', '--config', 'e2e/browsers/playwright.config.ts', ...positionals],
      ...(values.only ? ['--project', values.only] : []),
      ...(values.grep ? ['--grep', values.grep] : []),
    ],
    {
      FAROL_TESTS: values.all ? 'verify' : 'slice',
      ...(values.gpu ? { FAROL_GPU: '1' } : {}),
    },
  );
}
