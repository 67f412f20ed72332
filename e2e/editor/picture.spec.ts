import { pathToFileURL } from 'node:url';
import type { Locator, Page } from '@playwright/test';
import { compareImages, type FloatImage, isFlat } from '../support/images';
import { addObject, serialized } from './editor';
import { playerPicture } from './player';
import { expect, test } from './sharedEditor';

test.use({ viewport: { width: 840, height: 400 } });

/** Size of the pictures (pixels). */
const WIDTH = 160;
const HEIGHT = 90;

/** RGBA bytes as floats from 0 to 1. */
const decoded = (bytes: Buffer): FloatImage => ({
  width: WIDTH,
  height: HEIGHT,
  data: Array.from(bytes, (byte) => byte / 255),
});

/** The picture that the scene's camera gives, in the editor. */
async function picture(page: Page): Promise<FloatImage> {
  const bytes = await page.evaluate(
    async ([width, height]) => {
      const { viewport, document: edited } = window.editor;
      const { webgl, farol, picture: drawn } = viewport;
      await drawn.ready;
      const camera = edited.scene.activeCamera!;
      const [{ width: oldWidth, height: oldHeight }, ratio] = [viewport.canvas, webgl.getPixelRatio()];
      webgl.setPixelRatio(1);
      webgl.setSize(width, height, false);
      camera.setViewport(width, height);
      // what edges are smoothed by follows from the technique that has drawn
      let effects = null;
      while (farol.effects !== effects) {
        ({ effects } = farol);
        drawn.render(edited.scene, camera.three, camera);
      }
      const copy = Object.assign(document.createElement('canvas'), { width, height });
      const context = copy.getContext('2d')!;
      context.drawImage(viewport.canvas, 0, 0);
      webgl.setPixelRatio(ratio);
      webgl.setSize(oldWidth / ratio, oldHeight / ratio, false);
      return btoa(String.fromCharCode(...context.getImageData(0, 0, width, height).data));
    },
    [WIDTH, HEIGHT] as const,
  );
  return decoded(Buffer.from(bytes, 'base64'));
}

const psnr = (a: FloatImage, b: FloatImage): number => compareImages(a, b).psnr;

const inspectorOf = (page: Page): Locator => page.getByRole('region', { name: 'Inspector', exact: true });

async function choose(page: Page, field: string, option: string): Promise<void> {
  await inspectorOf(page).getByRole('combobox', { name: field, exact: true }).click();
  await page.getByRole('option', { name: option }).click();
}

/** Chooses a picture that differs from the plain one in most that there is to choose. */
async function choosePicture(page: Page): Promise<void> {
  await choose(page, 'Background', 'Gradient');
  await choose(page, 'Technique', 'Deferred shading');
  await choose(page, 'Tone mapping', 'AgX');
  for (const name of ['Vignette', 'Bloom', 'Ambient occlusion'])
    await inspectorOf(page).getByRole('checkbox', { name }).click();
  await expect.poll(() => effects(page)).toEqual(['ambient occlusion', 'SMAA']);
}

const effects = (page: Page): Promise<readonly string[]> =>
  page.evaluate(() => window.editor.viewport.farol.effects.map(({ name }) => name));

test('the picture is the scene’s: chosen, undone, saved, opened again', async ({ page }) => {
  await addObject(page, 'Mesh', 'Sphere');
  await page.evaluate(() => window.editor.document.selection.set([]));
  const plain = await picture(page);
  const before = await serialized(page);
  await choosePicture(page);
  const chosen = await picture(page);
  expect(isFlat(chosen)).toBe(false);
  expect(psnr(chosen, plain)).toBeLessThan(20);

  // what the technique cannot do is said
  await expect(inspectorOf(page).locator('.technique-limit')).toHaveCount(0);
  await choose(page, 'Technique', 'Forward, single pass');
  await expect(inspectorOf(page).locator('.technique-limit')).toContainText('ambient occlusion is left out');
  await expect.poll(() => effects(page)).toEqual([]);
  await page.keyboard.press('Control+z');
  await expect.poll(() => effects(page)).toEqual(['ambient occlusion', 'SMAA']);

  // in the file
  const open = (text: string): Promise<boolean> =>
    page.evaluate((bytes) => window.editor.openFileBytes(bytes, { name: null, handle: null }), text);
  const file = await serialized(page);
  const opened = open(before);
  await page.getByRole('dialog').getByRole('button', { name: 'Don’t save' }).click();
  await opened;
  expect(await page.evaluate(() => window.editor.viewport.technique)).toBe('auto');
  await expect.poll(() => effects(page)).not.toContain('ambient occlusion');
  await open(file);
  await expect.poll(() => effects(page)).toEqual(['ambient occlusion', 'SMAA']);
  expect(await page.evaluate(() => window.editor.viewport.technique)).toBe('deferred');
  expect(psnr(await picture(page), chosen)).toBeGreaterThan(45);
});

test('an exported page has the picture of the editor @verify', async ({ page, context }, info) => {
  await addObject(page, 'Mesh', 'Sphere');
  await page.evaluate(() => window.editor.document.selection.set([]));
  await choosePicture(page);
  const chosen = await picture(page);
  await page.keyboard.press('Control+Shift+E');
  const download = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Web page…' }).click();
  const html = info.outputPath('picture.html');
  await (await download).saveAs(html);
  const other = await context.newPage();
  const problems: string[] = [];
  other.on('pageerror', (error) => problems.push(error.message));
  other.on('console', (message) => message.type() === 'error' && problems.push(message.text()));
  await other.setViewportSize({ width: WIDTH, height: HEIGHT });
  await other.goto(pathToFileURL(html).href);
  expect(psnr(decoded(await playerPicture(other)), chosen)).toBeGreaterThan(34);
  expect(problems).toEqual([]);
});
