import type { Page } from '@playwright/test';
import type { Material, Mesh } from 'three';
import { byExtent } from '@farol/tools/extent';
import { loseContext } from '../support/loseContext';
import { expect, test } from '../support/test';
import { addObject, openEditor } from './editor';

const LOSSES = byExtent({ slice: 1, verify: 3, long: 100 });
const LOST = /a WebGL context was lost|Context Lost|Context Restored/i;

test.use({ viewport: { width: 840, height: 400 }, reducedMotion: 'reduce' });

/** Hash of the picture drawn now, made in the page: handing pixels over takes seconds. */
const picture = (page: Page): Promise<string> =>
  page.evaluate(async () => {
    const { viewport } = window.editor;
    const gl = viewport.webgl.getContext();
    await viewport.picture.ready;
    viewport.renderNow();
    const pixels = new Uint8Array(gl.drawingBufferWidth * gl.drawingBufferHeight * 4);
    gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    return Array.from(new Uint8Array(await crypto.subtle.digest('SHA-1', pixels))).join(' ');
  });

declare global {
  interface Window {
    /** While true no fence is reached: a read-back of pixels goes on, as on a slow device. */
    gpuIsBusy: boolean;
    /** The picture of the sphere's material, as numbers in a row. */
    ball: Promise<string>;
  }
}

/** Makes every read-back of the page last as long as `window.gpuIsBusy`, for a loss to come in the middle of one. */
async function holdReads(page: Page): Promise<void> {
  await page.addInitScript(() => {
    const { prototype } = WebGL2RenderingContext;
    const wait = prototype.clientWaitSync;
    prototype.clientWaitSync = function (...all) {
      return window.gpuIsBusy ? this.TIMEOUT_EXPIRED : wait.apply(this, all);
    };
  });
}

/** Starts drawing the ball of the sphere's material. */
const startBall = (page: Page, gpuIsBusy: boolean): Promise<void> =>
  page.evaluate((busy) => {
    window.gpuIsBusy = busy;
    const { viewport, document: edited } = window.editor;
    const canvas = Object.assign(document.createElement('canvas'), { width: 32, height: 32 });
    const { material } = edited.scene.find('Sphere')!.object3D.getObjectByProperty('type', 'Mesh') as Mesh;
    window.ball = viewport
      .drawMaterial(material as Material, canvas)
      .then(() => canvas.getContext('2d')!.getImageData(0, 0, 32, 32).data.join());
  }, gpuIsBusy);

const ball = (page: Page): Promise<string> =>
  page.evaluate(() => {
    window.gpuIsBusy = false;
    return window.ball;
  });

test('the editor after a lost context: the same picture, no message, also at another size @verify', async ({
  page,
  watch,
}) => {
  test.setTimeout(60_000 + 20_000 * LOSSES);
  await holdReads(page);
  await openEditor(page, 'empty');
  await addObject(page, 'Mesh', 'Sphere');
  await page.keyboard.press('f');
  await page.evaluate(() => {
    const { viewport, document } = window.editor;
    (viewport as { technique: string }).technique = 'deferred';
    document.selection.set([document.scene.componentsOf('Camera')[0].gameObject.id]);
  });
  await expect.poll(() => page.evaluate(() => window.editor.viewport.farol.effects.length)).toBe(1);
  const before = await picture(page);
  await startBall(page, false);
  const ballBefore = await ball(page);
  expect(new Set(ballBefore.split(',')).size).toBeGreaterThan(8);
  for (let loss = 0; loss < LOSSES; loss++) {
    await startBall(page, true);
    await loseContext(page, 'window.editor.viewport.canvas');
    expect(await ball(page), `material after loss ${loss + 1}`).toBe(ballBefore);
    expect(await picture(page), `picture after loss ${loss + 1}`).toBe(before);
    await page.setViewportSize({ width: 800, height: 380 });
    await picture(page);
    await page.setViewportSize({ width: 840, height: 400 });
    await expect.poll(() => picture(page)).toBe(before);
  }
  expect(watch.forgive(LOST)).toBeGreaterThanOrEqual(LOSSES);
});

test('a page with an attached editor after a lost context: the same picture, no message', async ({
  page,
  pagesURL,
  watch,
}) => {
  test.setTimeout(60_000 + 20_000 * LOSSES);
  await page.goto(`${pagesURL}attached.html`);
  await page.waitForFunction(() => 'attachedPage' in window);
  await page.evaluate(() => {
    const { attachEditor, webgl, scene, camera, farol } = window.attachedPage;
    const editor = attachEditor(scene, camera, webgl, { farol });
    Object.assign(window, { attachedEditor: editor });
  });
  const picture = () => page.evaluate(async () => (await window.attachedPage.pixels('farol')).join());
  const before = await picture();
  for (let loss = 0; loss < LOSSES; loss++) {
    await loseContext(page, 'window.attachedPage.webgl.domElement');
    expect((await picture()) === before).toBe(true);
    await page.evaluate(() => window.attachedPage.webgl.setSize(180, 100));
    await picture();
    await page.evaluate(() => window.attachedPage.webgl.setSize(200, 120));
    expect((await picture()) === before).toBe(true);
  }
  expect(watch.forgive(LOST)).toBeGreaterThanOrEqual(LOSSES);
});

test('a bake that a lost context ends leaves no notice, and the technique of the scene draws again @verify', async ({
  page,
  watch,
}) => {
  await openEditor(page, 'empty');
  await addObject(page, 'Mesh', 'Sphere');
  await addObject(page, 'Light', 'Point light');
  await page.evaluate(() => {
    const { viewport, document: edited } = window.editor;
    const { settings } = edited.scene;
    settings.set('technique', 'deferred');
    settings.set('bakeSize', '64');
    settings.set('bakeSamples', 4096);
    // as an edit or another scene does
    viewport.canvas.addEventListener('webglcontextlost', () => {
      settings.set('technique', 'tiled-deferred');
      viewport.renderNow();
    });
  });
  await page.getByRole('menuitem', { name: 'Object', exact: true }).click();
  await page.getByRole('menuitem', { name: 'Bake light…' }).click();
  const panel = page.getByRole('region', { name: 'Baked light' });
  await panel.getByRole('button', { name: 'Make 1 object static' }).click();
  await panel.getByRole('button', { name: /^Set \d lights? to Baked/ }).click();
  await panel.getByRole('button', { name: 'Bake', exact: true }).click();
  await expect(panel.getByText(/\d samples/)).toBeVisible();
  await loseContext(page, 'window.editor.viewport.canvas');
  await expect(panel.getByRole('button', { name: 'Bake', exact: true })).toBeVisible();
  await picture(page);
  expect(await page.evaluate(() => window.editor.viewport.farol.info.technique)).toBe('tiled-deferred');
  await expect(page.locator('.notice')).toHaveCount(0);
  expect(watch.forgive(LOST)).toBeGreaterThanOrEqual(1);
});
