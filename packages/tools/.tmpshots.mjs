import { chromium } from 'playwright-core';
import { softwareFlags } from './browserFlags.mjs';
import { ensureBrowser } from './ensureBrowser.mjs';
import { serveApps } from './serveApps.mjs';
const dir = '/work/tmp-rest32';
const server = await serveApps({ ports: { editor: 0 }, watch: false });
const browser = await chromium.launch({ executablePath: ensureBrowser(), args: [...softwareFlags] });
const open = async (width, height, query, options = {}) => {
  const page = await browser.newPage({ bypassCSP: true, viewport: { width, height }, ...options });
  page.setDefaultTimeout(200_000);
  page.on('pageerror', (e) => console.log('page error', e.message));
  await page.goto(`${server.urls.editor}?${query}`);
  await page.waitForFunction(() => 'editor' in window);
  await page.evaluate(() => window.editor.ready);
  return page;
};
try {
  const lib = await open(1440, 900, 'scene=empty', { locale: 'es-ES', colorScheme: 'light' });
  await lib.evaluate(() => window.editor.layout.open('library'));
  await lib.evaluate(() => window.editor.layout.maximise('library'));
  await lib.waitForTimeout(5000);
  await lib.screenshot({ path: `${dir}/lib-es2.png` });
  await lib.close();
  const page = await open(1280, 720, 'scene=empty', { colorScheme: 'dark', locale: 'en-US' });
  await page.evaluate(async () => {
    const { viewport } = window.editor;
    await window.editor.openSample('temple');
    viewport.technique = 'deferred';
    window.editor.commands.clear();
    await viewport.farol.ready;
  });
  await page.waitForTimeout(15000);
  await page.evaluate(() => window.editor.viewport.renderNow());
  await page.screenshot({ path: `${dir}/temple.png` });
  console.log('temple');
} finally {
  await browser.close();
  await server.close();
}
