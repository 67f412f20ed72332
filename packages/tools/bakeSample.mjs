/**
 * Bakes the light of the sample 'Baked room' anew, by the editor itself in a browser, and writes its file in
 * `public/scenes`. makeSamples.mjs keeps what was baked; run it first after a change of the sample.
 *
 *     node packages/tools/makeSamples.mjs
 *     node packages/tools/bakeSample.mjs            # on the software rasteriser: some minutes
 *     node packages/tools/bakeSample.mjs --gpu
 *
 * For a GPU host without Vite: `--built --out FILE` bakes by the built editor and writes the baked light alone. Put FILE at
 * `public/scenes/baked-room.bake` here, run makeSamples.mjs, and delete it.
 */
import { execFileSync } from 'node:child_process';
import { rmSync, writeFileSync } from 'node:fs';
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
  const data = /** @type {number[]} */ (
    await page.evaluate(async () => {
      const { editor } = /** @type {any} */ (window);
      const { scene } = editor.document;
      const [notice] = editor.notices.current;
      if (editor.commands.history.length === 0) throw new Error(notice?.text ?? 'Nothing was baked.');
      const blob = scene.assets.fileOf(scene.settings.bakedLight);
      return [...new Uint8Array(await blob.arrayBuffer())];
    })
  );
  const seconds = ((Date.now() - begun) / 1000).toFixed(0);
  const path = values.out ?? join(root, `public/scenes/${NAME}.bake`);
  writeFileSync(path, Uint8Array.from(data));
  if (values.out === undefined) {
    execFileSync(process.execPath, [join(root, 'packages/tools/makeSamples.mjs')]);
    rmSync(path);
  }
  console.log(`${NAME}: ${(data.length / 1000).toFixed(1)} kB of baked light in ${seconds} s`);
} finally {
  await browser.close();
  await server.close();
}
