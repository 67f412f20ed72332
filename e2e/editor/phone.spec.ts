import type { Page } from '@playwright/test';
import { serveApps } from '@farol/tools/serveApps';
import { expect, test as base } from '../support/test';
import { inspectorFollows } from './editor';
import { test as shared } from './sharedEditor';

/** With the editor's sources served to the network, which takes seconds. */
const test = base.extend<{ served: Awaited<ReturnType<typeof serveApps>> }>({
  // oxlint-disable-next-line no-empty-pattern -- Playwright reads the names of the fixtures from the pattern
  served: async ({}, use) => {
    const served = await serveApps({
      ...{ ports: { editor: 0 }, network: { editor: 0 }, hosts: ['127.0.0.1'], watch: false },
    });
    await use(served);
    await served.close();
  },
});

/** A scene file: a white ball under a white lamp, before a camera. */
function ballScene(): string {
  const object = (id: string, place: object, type: string, values: object): object => ({
    ...{ id, name: id, parent: null },
    components: [
      { type: 'Transform', version: 1, id: `${id}-place`, values: place },
      { type, version: 1, id: `${id}-part`, values },
    ],
  });
  return JSON.stringify({
    ...{ format: 'farol-scene', version: 3, name: 'Ball', activeCamera: 'Camera', assets: [] },
    settings: { background: 'colour', backgroundColour: [0, 0, 0], antialiasing: 'none' },
    objects: [
      object('Camera', { position: [0, 0, 6] }, 'Camera', {}),
      object('Ball', { position: [0, 0.6, 0] }, 'ObjectRenderer', { mesh: 'sphere', colour: [1, 1, 1] }),
      object('Lamp', { position: [0, 0, 4] }, 'Light', { type: 'point', intensity: 60, castShadow: false }),
    ],
  });
}

interface Look {
  /** Mean height of what is lit, from 0 (top) to 1. */
  readonly height: number;
  /** Share of the light of what is lit, by channel. */
  readonly red: number;
  readonly blue: number;
}

/** Light in the picture of a page that plays a scene. */
const lookAt = (page: Page): Promise<Look | null> =>
  page.evaluate(async () => {
    const canvas = document.querySelector('canvas');
    if (!canvas?.ariaLabel) return null;
    // what a canvas shows is kept for the turn of the page in which it is drawn
    await new Promise(requestAnimationFrame);
    const copy = Object.assign(document.createElement('canvas'), { width: 64, height: 128 });
    const context = copy.getContext('2d', { willReadFrequently: true })!;
    context.drawImage(canvas, 0, 0, 64, 128);
    const { data } = context.getImageData(0, 0, 64, 128);
    const sums = [0, 0, 0];
    let rows = 0;
    for (let i = 0; i < data.length; i += 4) {
      for (let k = 0; k < 3; k++) sums[k] += data[i + k];
      rows += (data[i] + data[i + 1] + data[i + 2]) * Math.floor(i / 256);
    }
    const all = sums[0] + sums[1] + sums[2];
    return all === 0 ? null : { height: rows / all / 128, red: sums[0] / all, blue: sums[2] / all };
  });

test('a phone shows the scene, follows a moved object and, over a lost connection, a recoloured lamp, and is counted @verify', async ({
  page,
  browser,
  served,
  watch,
}) => {
  test.slow();
  await page.goto(`${served.urls.editor}?scene=empty`);
  await page.waitForFunction(() => 'editor' in window);
  await page.evaluate(async (text) => {
    await window.editor.ready;
    await window.editor.openFileBytes(text, { name: 'ball.farol', handle: null });
  }, ballScene());

  await page.getByRole('menuitem', { name: 'File', exact: true }).click();
  await page.getByRole('menuitem', { name: 'Open on a phone…' }).click();
  const dialog = page.getByRole('dialog');
  await expect(dialog.getByText('nobody looks')).toBeVisible();
  const address = await dialog.getByLabel('Address for the phone').inputValue();
  // the end of the address is seen
  const rest = await dialog
    .getByLabel('Address for the phone')
    .evaluate((input: HTMLInputElement) => input.scrollWidth - input.clientWidth - input.scrollLeft);
  expect(rest).toBeLessThan(2);
  expect(address).toMatch(/^https:\/\/127\.0\.0\.1:\d+\/live\.html\?token=[\w-]{16}&look=[0-9a-f]{16}$/);

  const context = await browser.newContext({
    ...{ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true, ignoreHTTPSErrors: true },
  });
  const phone = await context.newPage();
  phone.on('pageerror', (error) => watch.problems.push(`phone: ${error.message}`));
  phone.on('console', (message) => message.type() === 'error' && watch.problems.push(`phone: ${message.text()}`));
  let lose: () => Promise<void> = async () => {};
  await phone.routeWebSocket(/farol-live/, (socket) => {
    socket.connectToServer();
    lose = () => socket.close();
  });
  await phone.goto(address);
  await expect(dialog.getByText('1 looks')).toBeVisible();
  await expect.poll(async () => (await lookAt(phone))?.height ?? 1, { timeout: 60_000 }).toBeLessThan(0.47);
  const before = (await lookAt(phone))!;
  expect(Math.abs(before.red - before.blue), 'a white ball is as red as blue').toBeLessThan(0.02);

  await dialog.getByRole('button', { name: 'Close' }).click();
  await expect(page.locator('.status').getByText('1 looks')).toBeVisible();
  await page.getByRole('treeitem', { name: 'Ball' }).click();
  await inspectorFollows(page);
  await page.getByLabel('Position y').fill('-0.6');
  await page.getByLabel('Position y').press('Enter');
  await expect.poll(async () => (await lookAt(phone))?.height ?? 0).toBeGreaterThan(0.53);

  // what was edited while the connection was away comes with the next one
  await lose();
  await page.getByRole('treeitem', { name: 'Lamp' }).click();
  await inspectorFollows(page);
  await page.getByRole('region', { name: 'Light' }).getByRole('button', { name: 'Colour', exact: true }).click();
  await page.getByLabel('Colour as sRGB').fill('#0000ff');
  await page.getByLabel('Colour as sRGB').press('Enter');
  await expect.poll(async () => (await lookAt(phone))?.blue ?? 0).toBeGreaterThan(0.9);
  await page.keyboard.press('Escape');

  // Play begins the phone's scene anew: it names itself
  await phone.evaluate(() => (document.title = 'before Play'));
  await page.getByRole('button', { name: 'Play', exact: true }).click();
  await expect.poll(() => phone.title()).toBe('Ball');

  await phone.close();
  await expect(page.locator('.status').getByText('nobody looks')).toBeVisible();
  await context.close();
});

shared('a server that the network does not reach says how to start it, as often as it is asked', async ({ page }) => {
  for (let i = 0; i < 2; i++) {
    await page.getByRole('menuitem', { name: 'File', exact: true }).click();
    await page.getByRole('menuitem', { name: 'Open on a phone…' }).click();
    const dialog = page.getByRole('dialog');
    await expect(dialog.getByRole('textbox', { name: 'Command' })).toHaveValue('npm start -- --host');
    await dialog.getByRole('button', { name: 'Close' }).click();
    await expect(dialog).toBeHidden();
  }
});
