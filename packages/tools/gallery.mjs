/**
 * `npm run gallery`: draws every example of the site's gallery on the software rasteriser, and keeps its picture
 * (`apps/site/live/assets/stills/gallery`) and how far it is from stock three's (`figures.json` beside the examples).
 *
 *     npm run gallery
 *     npm run gallery -- night-street campfire
 */
import { ensureBrowser } from './ensureBrowser.mjs';
import { ensureInstalled } from './ensureInstalled.mjs';
import { runTool } from './runTool.mjs';
import { figuresFile } from './site/galleryExamples.mjs';

ensureInstalled();
const names = process.argv.slice(2);
const chosen = names.length > 0 ? ['-g', `(${names.join('|')}): what`] : [];
const code = runTool(
  '@playwright/test',
  'playwright',
  ['test', '-c', 'e2e/playwright.config.ts', '--workers=1', 'gallery/', ...chosen],
  { CHROMIUM_PATH: ensureBrowser(), FAROL_GALLERY: '1', FAROL_TESTS: 'verify' },
);
runTool('oxfmt', 'oxfmt', [figuresFile]);
process.exit(code);
