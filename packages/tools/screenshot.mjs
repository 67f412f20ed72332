/**
 * Takes a picture of a page in headless Chromium on the software rasteriser, and prints what the console said:
 *
 *     node packages/tools/screenshot.mjs URL OUT.png [--width 1280] [--height 720] [--wait 'window.viewer?.ready']
 *
 * `--wait` is an expression in the page, awaited before the picture.
 */
import { parseArgs } from 'node:util';
import { chromium } from 'playwright-core';
import { softwareFlags } from './browserFlags.mjs';
import { ensureBrowser } from './ensureBrowser.mjs';

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    width: { type: 'string', default: '1280' },
    height: { type: 'string', default: '720' },
    wait: { type: 'string', default: 'true' },
  },
});
const [url, out] = positionals;
if (!url || !out) {
  console.error('Usage: node packages/tools/screenshot.mjs URL OUT.png [--width n] [--height n] [--wait expression]');
  process.exit(1);
}

const browser = await chromium.launch({ executablePath: ensureBrowser(), args: [...softwareFlags] });
try {
  const page = await browser.newPage({ viewport: { width: Number(values.width), height: Number(values.height) } });
  page.on('console', (message) => console.log(`${message.type()}: ${message.text()}`));
  page.on('pageerror', (error) => console.log(`page error: ${error.message}`));
  await page.goto(url);
  await page.evaluate(values.wait);
  await page.screenshot({ path: out });
  console.log(out);
} finally {
  await browser.close();
}
