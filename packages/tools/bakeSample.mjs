/**
 * Bakes the light of the sample 'Baked room' anew, by the editor itself in a browser, and saves its file in `public/scenes`.
 *
 *     node packages/tools/bakeSample.mjs            # on the software rasteriser: some minutes
 *     node packages/tools/bakeSample.mjs --gpu
 *
 * For a GPU host without Vite: `--built --out FILE` bakes by the built editor and saves the scene as FILE.
 */
import { statSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { chromium } from 'playwright-core';
import { gpuFlags, softwareFlags } from './browserFlags.mjs';
import { ensureBrowser } from './ensureBrowser.mjs';
import { root } from './root.mjs';
import { serveApps } from './serveApps.mjs';

const NAME = 'baked-room';

const { values } = parseArgs({
  options: { gpu: { type: 'boolean' }, built: { type: 'boolean' }, out: { type: 'string' } },
});
const flags = values.gpu ? gpuFlags : softwareFlags;
const server = await serveApps({ ports: { editor: 0 }, built: values.built, watch: false });
const browser = await chromium.launch({ executablePath: ensureBrowser(), args: [...flags] });
try {
  const page = await browser.newPage({ viewport: { width: 480, height: 360 }, acceptDownloads: true });
  page.setDefaultTimeout(0);
  // saving is then a download, which can be answered here
  await page.addInitScript(() => void Reflect.deleteProperty(window, 'showSaveFilePicker'));
  page.on('pageerror', (error) => console.log(`page error: ${error.message}`));
  await page.goto(`${server.urls.editor}?scene=empty`);
  await page.waitForFunction(() => 'editor' in window);
  const begun = Date.now();
  await page.evaluate(async (name) => {
    const { editor } = /** @type {any} */ (window);
    await editor.ready;
    await editor.openSample(name);
    editor.layout.open('bake');
  }, NAME);
  await page.getByRole('button', { name: 'Bake', exact: true }).click();
  const isDone = () => {
    const { editor } = /** @type {any} */ (window);
    return editor.commands.history.length > 0 || editor.notices.current.length > 0;
  };
  const timer = setInterval(() => {
    void page
      .locator('.bake-running')
      .innerText()
      .then((text) => console.log(text.replaceAll('\n', ' ')));
  }, 30_000);
  await page.waitForFunction(isDone, null, { polling: 1000 });
  clearInterval(timer);
  const problem = await page.evaluate(() => {
    const { editor } = /** @type {any} */ (window);
    return editor.commands.history.length > 0 ? null : (editor.notices.current[0]?.text ?? 'Nothing was baked.');
  });
  if (problem !== null) throw new Error(problem);
  const seconds = ((Date.now() - begun) / 1000).toFixed(0);
  const download = page.waitForEvent('download');
  await page.evaluate(() => {
    const { editor } = /** @type {any} */ (window);
    return editor.actions.get('file.save').run(editor);
  });
  const path = values.out ?? join(root, `public/scenes/${NAME}.farol`);
  await (await download).saveAs(path);
  console.log(`${NAME}: ${(statSync(path).size / 1000).toFixed(1)} kB, baked in ${seconds} s`);
} finally {
  await browser.close();
  await server.close();
}
