import { writeFileSync } from 'node:fs';
import { chromium } from 'playwright-core';
import { softwareFlags } from './browserFlags.mjs';
import { ensureBrowser } from './ensureBrowser.mjs';
import { serveApps } from './serveApps.mjs';

/**
 * Opens the editor on the software rasteriser, and closes it once used.
 *
 * @param {string} query - of the editor's address
 * @param {{ width: number, height: number }} viewport - size of the page (CSS pixels)
 * @param {(page: import('playwright-core').Page) => Promise<void>} use
 */
export async function withEditor(query, viewport, use) {
  const server = await serveApps({ ports: { editor: 0 }, watch: false });
  const browser = await chromium.launch({ executablePath: ensureBrowser(), args: [...softwareFlags] });
  try {
    const page = await browser.newPage({ viewport });
    page.setDefaultTimeout(180_000);
    page.on('pageerror', (error) => console.log(`page error: ${error.message}`));
    await page.goto(`${server.urls.editor}?${query}`);
    await page.waitForFunction('window.editor');
    await page.evaluate('window.editor.ready');
    await use(page);
  } finally {
    await browser.close();
    await server.close();
  }
}

/**
 * Draws the scene, and saves the middle of the picture as a WebP.
 *
 * @param {import('playwright-core').Page} page
 * @param {string} file
 * @param {{ width: number, height: number, quality: number }} size - in pixels; quality 0 to 1
 * @returns {Promise<number>} size of the file (bytes)
 */
export async function savePicture(page, file, size) {
  const data = await page.evaluate(({ width, height, quality }) => {
    const { viewport } = /** @type {any} */ (window).editor;
    viewport.renderNow();
    const { canvas } = viewport;
    const tall = Math.min(canvas.height, (canvas.width * height) / width);
    const wide = (tall * width) / height;
    const picture = document.createElement('canvas');
    picture.width = width;
    picture.height = height;
    const context = picture.getContext('2d');
    if (!context) throw new Error('The browser has no 2D canvas.');
    context.imageSmoothingQuality = 'high';
    const [x, y] = [(canvas.width - wide) / 2, (canvas.height - tall) / 2];
    context.drawImage(canvas, x, y, wide, tall, 0, 0, width, height);
    return picture.toDataURL('image/webp', quality);
  }, size);
  const bytes = Buffer.from(data.slice(data.indexOf(',') + 1), 'base64');
  writeFileSync(file, bytes);
  console.log(`${file.slice(file.lastIndexOf('/') + 1)}: ${(bytes.length / 1000).toFixed(1)} kB`);
  return bytes.length;
}
