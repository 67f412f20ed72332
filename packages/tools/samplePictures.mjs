/**
 * Makes the pictures of the samples that the editor's welcome shows, by the editor itself on the software
 * rasteriser.
 *
 *     node packages/tools/samplePictures.mjs
 *     node packages/tools/samplePictures.mjs prefabs temple
 */
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { chromium } from 'playwright-core';
import { softwareFlags } from './browserFlags.mjs';
import { ensureBrowser } from './ensureBrowser.mjs';
import { root } from './root.mjs';
import { serveApps } from './serveApps.mjs';

/** CSS pixels of a picture; it is drawn at twice that. */
const WIDTH = 320;
const HEIGHT = 180;
/** Quality of the WebP pictures, 0 to 1. */
const QUALITY = 0.82;

const folder = join(root, 'apps/editor/src/panels/welcome/pictures');
const server = await serveApps({ ports: { editor: 0 }, watch: false });
const browser = await chromium.launch({ executablePath: ensureBrowser(), args: [...softwareFlags] });
try {
  const page = await browser.newPage({ viewport: { width: 1280, height: 800 } });
  page.setDefaultTimeout(180_000);
  page.on('pageerror', (error) => console.log(`page error: ${error.message}`));
  await page.goto(`${server.urls.editor}?scene=empty`);
  await page.waitForFunction('window.editor');
  await page.evaluate('window.editor.ready');
  const names = /** @type {string[]} */ (await page.evaluate('Object.keys(window.editor.samples)'));
  const wanted = process.argv.slice(2);
  for (const name of names) {
    if (wanted.length > 0 && !wanted.includes(name)) continue;
    const data = /** @type {string} */ (
      await page.evaluate(
        async ([scene, width, height, quality]) => {
          const { editor } = /** @type {any} */ (window);
          const { viewport } = editor;
          await editor.openSample(scene);
          editor.layout.maximise('viewport');
          viewport.showGrid = false;
          viewport.showIcons = false;
          // a frame asks for the code of effects, which is fetched; fog and others gather frames
          for (let calm = 0, count = -1; calm < 3;) {
            viewport.renderNow();
            await new Promise((resolve) => setTimeout(resolve, 4000));
            await viewport.farol.ready;
            calm = count === viewport.farol.effects.length ? calm + 1 : 0;
            count = viewport.farol.effects.length;
          }
          for (let frame = 0; frame < 6; frame++) viewport.renderNow();
          // the middle of the picture, in its shape
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
        },
        /** @type {[string, number, number, number]} */ ([name, WIDTH * 2, HEIGHT * 2, QUALITY]),
      )
    );
    const bytes = Buffer.from(data.slice(data.indexOf(',') + 1), 'base64');
    writeFileSync(join(folder, `${name}.webp`), bytes);
    console.log(`${name}.webp: ${(bytes.length / 1000).toFixed(1)} kB`);
  }
} finally {
  await browser.close();
  await server.close();
}
