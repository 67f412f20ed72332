/**
 * Makes the pictures of the samples that the editor's welcome shows, by the editor itself on the software
 * rasteriser.
 *
 *     node packages/tools/samplePictures.mjs
 *     node packages/tools/samplePictures.mjs prefabs temple
 */
import { join } from 'node:path';
import { savePicture, withEditor } from './editorPictures.mjs';
import { root } from './root.mjs';

/** CSS pixels of a picture; it is drawn at twice that. */
const WIDTH = 320;
const HEIGHT = 180;
/** Quality of the WebP pictures, 0 to 1. */
const QUALITY = 0.82;

const folder = join(root, 'apps/editor/src/panels/welcome/pictures');
await withEditor('scene=empty', { width: 1280, height: 800 }, async (page) => {
  const names = /** @type {string[]} */ (await page.evaluate('Object.keys(window.editor.samples)'));
  const wanted = process.argv.slice(2);
  for (const name of names) {
    if (wanted.length > 0 && !wanted.includes(name)) continue;
    await page.evaluate(async (scene) => {
      const { editor } = /** @type {any} */ (window);
      const { viewport } = editor;
      await editor.openSample(scene);
      editor.layout.maximise('viewport');
      viewport.showGrid = false;
      viewport.showIcons = false;
      // a frame starts fetching the code of effects that it needs; fog and some others average several frames
      for (let calm = 0, count = -1; calm < 3;) {
        viewport.renderNow();
        await new Promise((resolve) => setTimeout(resolve, 4000));
        await viewport.farol.ready;
        calm = count === viewport.farol.effects.length ? calm + 1 : 0;
        count = viewport.farol.effects.length;
      }
      for (let frame = 0; frame < 5; frame++) viewport.renderNow();
    }, name);
    await savePicture(page, join(folder, `${name}.webp`), { width: WIDTH * 2, height: HEIGHT * 2, quality: QUALITY });
  }
});
