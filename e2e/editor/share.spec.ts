import { readFile } from 'node:fs/promises';
import { pathToFileURL } from 'node:url';
import { deflateRawSync } from 'node:zlib';
import type { Download, Page } from '@playwright/test';
import { expect, test } from '../support/test';
import { axeProblemsInVerify as axeProblems } from '../support/axeProblems';
import { addObject, serialized, waitUntilReady } from './editor';
import { dropFiles, redBox } from './models';

test.use({ viewport: { width: 900, height: 560 }, reducedMotion: 'reduce' });

async function openWithBox(page: Page): Promise<void> {
  await page.addInitScript(() => {
    // the fallback, a download, is what a test can answer
    Reflect.deleteProperty(window, 'showOpenFilePicker');
    Reflect.deleteProperty(window, 'showSaveFilePicker');
  });
  await page.goto('./?scene=empty');
  await waitUntilReady(page);
  await dropFiles(page, '.viewport-place canvas', [redBox()]);
  await expect(page.getByRole('treeitem', { name: 'box' })).toBeVisible();
}

async function exported(page: Page, button: string): Promise<Download> {
  const download = page.waitForEvent('download');
  await page.getByRole('button', { name: button }).click();
  return download;
}

/** How much of a page is red, from 0 to 1. */
const redShare = (page: Page): Promise<number> =>
  page.locator('canvas').evaluate(async (canvas: HTMLCanvasElement) => {
    const copy = document.createElement('canvas');
    copy.width = canvas.width;
    copy.height = canvas.height;
    const context = copy.getContext('2d')!;
    await new Promise(requestAnimationFrame);
    // within the frame that was just drawn
    await new Promise<void>((resolve) => {
      requestAnimationFrame(() => {
        context.drawImage(canvas, 0, 0);
        resolve();
      });
    });
    const { data } = context.getImageData(0, 0, copy.width, copy.height);
    let red = 0;
    for (let i = 0; i < data.length; i += 4) if (data[i] > 60 && data[i + 1] < data[i] / 3) red++;
    return (red * 4) / data.length;
  });

test('exported as a web page it runs from a disk, as glTF it comes back @verify', async ({ page, context }, info) => {
  await openWithBox(page);
  await page.keyboard.press('Control+Shift+E');
  const html = info.outputPath('scene.html');
  await (await exported(page, 'Web page…')).saveAs(html);
  const glb = info.outputPath('scene.glb');
  await (await exported(page, 'glTF (GLB)…')).saveAs(glb);
  await page.getByRole('button', { name: 'Close', exact: true }).click();

  const fromDisk = await context.newPage();
  const problems: string[] = [];
  fromDisk.on('pageerror', (error) => problems.push(error.message));
  fromDisk.on('console', (message) => message.type() === 'error' && problems.push(message.text()));
  fromDisk.on('request', (request) => {
    if (!/^(file|data|blob):/.test(request.url())) problems.push(`asked for ${request.url()}`);
  });
  await fromDisk.setViewportSize({ width: 320, height: 180 });
  await fromDisk.goto(pathToFileURL(html).href);
  await expect(fromDisk).toHaveTitle('Untitled');
  await expect.poll(() => redShare(fromDisk)).toBeGreaterThan(0.005);
  expect(problems).toEqual([]);
  await fromDisk.screenshot({ path: info.outputPath('from-disk.png') });
  await fromDisk.close();

  await dropFiles(page, '.viewport-place canvas', [{ name: 'again.glb', bytes: await readFile(glb) }]);
  await expect(page.getByRole('treeitem', { name: 'again' })).toBeVisible();
  const names = await page.evaluate(() => {
    const list: string[] = [];
    window.editor.document.scene.find('again')!.object3D.traverse(({ name }) => list.push(name));
    return list;
  });
  expect(names).toEqual(expect.arrayContaining(['box', 'Box', 'Sun', 'Camera']));
});

test('a link opens the same scene, and so does the frame @verify', async ({ page, context }) => {
  await openWithBox(page);
  await addObject(page, 'Mesh', 'Torus');
  const scene = await serialized(page);
  await page.keyboard.press('Control+Shift+E');
  await expect(page.getByLabel('Link to the scene')).toHaveValue(/#/);
  const link = await page.getByLabel('Link to the scene').inputValue();
  expect(link.length).toBeLessThan(64_000);
  expect(await axeProblems(page)).toEqual([]);
  await expect(page.getByLabel('Embed code', { exact: true }).first()).toContainText('player.html#scene=');
  const frame = /src="([^"]+)"/.exec(await page.locator('textarea').inputValue())![1];
  await page.getByRole('button', { name: 'Close', exact: true }).click();

  const other = await context.newPage();
  await other.goto(link);
  await waitUntilReady(other);
  await expect(other.getByRole('treeitem', { name: 'Torus' })).toBeVisible();
  expect(await serialized(other)).toBe(scene);

  await other.setViewportSize({ width: 320, height: 180 });
  await other.goto(frame);
  await expect.poll(() => redShare(other)).toBeGreaterThan(0.005);
  await other.close();
});

test('a link that grows large when it is unpacked is asked about; what is too large for one says so @verify', async ({
  page,
  context,
}) => {
  await openWithBox(page);
  // from 100 kB to 100 MB, of blanks: no scene
  const bomb = `./#scene=${deflateRawSync(Buffer.alloc(100 * 2 ** 20, ' ')).toString('base64url')}`;
  const large = await context.newPage();
  await large.goto(bomb);
  const question = large.getByRole('dialog', { name: 'A large scene' });
  await expect(question).toContainText(/grows from \d+ kB to \d+ MB when it is unpacked/);
  await question.getByRole('button', { name: 'Cancel' }).click();
  await expect(large.getByRole('dialog')).toHaveCount(0);
  await expect(large.getByRole('alert')).toHaveCount(0);
  await large.close();

  // bytes that do not become smaller, the same each time
  let state = 1;
  const noise = Buffer.from(Array.from({ length: 100_000 }, () => (state = (state * 48_271) % 2_147_483_647) & 255));
  const json = JSON.parse(redBox().bytes.toString()) as object;
  const padded = JSON.stringify({ ...json, extras: { noise: noise.toString('base64') } });
  await dropFiles(page, '.viewport-place canvas', [{ name: 'large.gltf', bytes: Buffer.from(padded) }]);
  await expect(page.getByRole('treeitem', { name: 'large' })).toBeVisible();
  await page.keyboard.press('Control+Shift+E');
  await expect(page.getByRole('alert')).toContainText(/The link would have \d+ kB, and 64 kB is the limit/);
  await expect(page.getByRole('alert')).toContainText('large.glb');
});
