import type { Page } from '@playwright/test';
import { readFileSync } from 'node:fs';
import { compareImages, type FloatImage } from '../support/images';
import { addObject } from './editor';
import { expect, test } from './sharedEditor';

/** Saves the picture by its dialog. @returns the file, read by the browser, scaled to 1050 × 80 pixels */
async function save(page: Page, width: number, height: number, isTransparent = false): Promise<FloatImage> {
  await page.getByRole('menuitem', { name: 'File', exact: true }).click();
  await page.getByRole('menuitem', { name: 'Save a picture…' }).click();
  const dialog = page.getByRole('dialog', { name: 'Save a picture' });
  for (const [label, value] of [
    ['Width', width],
    ['Height', height],
  ] as const) {
    await dialog.getByLabel(label, { exact: true }).fill(String(value));
    await dialog.getByLabel(label, { exact: true }).press('Enter');
  }
  if (isTransparent) await dialog.getByLabel('Without background').click();
  const download = page.waitForEvent('download');
  await dialog.getByRole('button', { name: 'Save' }).click();
  const file = readFileSync(await (await download).path());
  expect([file.readUInt32BE(16), file.readUInt32BE(20)]).toEqual([width, height]);
  const data = await page.evaluate(async (text) => {
    const png = new Blob([Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0))], { type: 'image/png' });
    const bitmap = await createImageBitmap(png, { resizeWidth: 1050, resizeHeight: 80, resizeQuality: 'high' });
    const context = new OffscreenCanvas(1050, 80).getContext('2d')!;
    context.drawImage(bitmap, 0, 0);
    return Array.from(context.getImageData(0, 0, 1050, 80).data, (byte) => byte / 255);
  }, file.toString('base64'));
  return { width: 1050, height: 80, data };
}

test('a picture of tiles is that of one piece, with nothing behind the objects where asked @verify', async ({
  page,
}) => {
  await addObject(page, 'Mesh', 'Sphere');
  const whole = await save(page, 2100, 160);
  const tiles = await save(page, 4200, 320);
  expect(compareImages(tiles, whole).psnr).toBeGreaterThan(34);
  const alphas = ({ data }: FloatImage) => {
    const all = Array.from({ length: data.length / 4 }, (_, i) => data[4 * i + 3]);
    return [Math.min(...all), Math.max(...all)];
  };
  expect(alphas(tiles)).toEqual([1, 1]);
  expect(alphas(await save(page, 4200, 320, true))).toEqual([0, 1]);
  // the viewport draws on, at its own size
  const shapes = await page.evaluate(() => {
    const { canvas } = window.editor.viewport;
    return [canvas.width / canvas.height, canvas.clientWidth / canvas.clientHeight];
  });
  expect(shapes[0]).toBeCloseTo(shapes[1], 1);
});

test('a scene has a picture in its file: of its view, or of one that was chosen @verify', async ({ page }) => {
  const picture = () =>
    page.evaluate(
      () => (JSON.parse(window.editor.serialize()) as { picture?: { url: string; chosen?: true } }).picture,
    );
  const saveScene = async (): Promise<void> => {
    const download = page.waitForEvent('download');
    await page.keyboard.press('Control+s');
    await (await download).path();
  };
  await addObject(page, 'Mesh', 'Sphere');
  expect(await picture()).toBeUndefined();
  await saveScene();
  const first = (await picture())!;
  expect(first.url).toMatch(/^data:image\/webp;base64,/);
  expect(first.url.length).toBeLessThan((20_000 * 4) / 3 + 30);
  await page.getByRole('menuitem', { name: 'File', exact: true }).click();
  await page.getByRole('menuitem', { name: 'Use this view as the scene’s picture' }).click();
  await expect.poll(async () => (await picture())?.chosen).toBe(true);
  const chosen = (await picture())!;
  await page.evaluate(() =>
    window.editor.document.scene.find('Sphere')!.getComponent('Transform')!.set('position', [0, 0.5, 3]),
  );
  await saveScene();
  expect(await picture(), 'saving keeps what was chosen').toEqual(chosen);
  await page.keyboard.press('Control+z');
  expect(await picture()).toEqual(first);
  await saveScene();
  expect((await picture())!.url, 'of the view as it is now').not.toBe(first.url);
});
