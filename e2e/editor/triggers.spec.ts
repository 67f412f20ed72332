import { readFileSync } from 'node:fs';
import type { Page } from '@playwright/test';
import { addObject, fieldOf, history, pointOf, serialized } from './editor';
import { dropFiles } from './models';
import { expect, test } from './sharedEditor';

test.use({ viewport: { width: 1200, height: 700 }, reducedMotion: 'reduce' });

const thud = readFileSync(new URL('../../public/sounds/thud.wav', import.meta.url));

async function addComponent(page: Page, words: string): Promise<void> {
  await page.getByRole('combobox', { name: 'Add component' }).click();
  await page.getByRole('combobox', { name: 'Search: Add component' }).fill(words);
  await page.getByRole('option').first().click();
  await expect(page.getByRole('listbox')).toHaveCount(0);
}

/** Whether the lamp's light is on, and how many sounds are heard of the looping ones that were begun. */
const lampOf = (page: Page): Promise<readonly [lit: boolean, heard: number]> =>
  page.evaluate(() => {
    const lamp = window.editor.document.scene.find('Sphere')!;
    return [lamp.getComponent('Light')!.enabled, Number(document.documentElement.dataset.heard ?? 0)] as const;
  });

test('a lamp is switched by a click on it, with a sound, made by hand; stop puts all back @verify', async ({
  page,
}) => {
  await page.evaluate(() => {
    const { start, stop } = AudioBufferSourceNode.prototype;
    const add = (node: AudioBufferSourceNode, change: number): void => {
      const { dataset } = document.documentElement;
      if (node.loop && node.context.state === 'running') dataset.heard = String(Number(dataset.heard ?? 0) + change);
    };
    AudioBufferSourceNode.prototype.start = function (...times) {
      add(this, 1);
      start.apply(this, times);
    };
    AudioBufferSourceNode.prototype.stop = function (...times) {
      add(this, -1);
      stop.apply(this, times);
    };
    const putBack = (): void => {
      Object.assign(AudioBufferSourceNode.prototype, { start, stop });
      delete document.documentElement.dataset.heard;
    };
    Object.assign(window, { putBack });
  });
  // a file that is no sound says so, a sound becomes an asset with its length
  await dropFiles(page, '.assets-body', [{ name: 'noise.mp3', bytes: Buffer.from('no sound at all') }]);
  await expect(page.getByText('noise.mp3 cannot be imported: it cannot be decoded')).toBeVisible();
  await dropFiles(page, '.assets-body', [{ name: 'thud.wav', bytes: thud }]);
  const card = page.locator('.assets-grid li').filter({ hasText: 'thud.wav' });
  await expect(card).toContainText('0.7 s');
  await expect(card.locator('img')).toBeVisible();
  await card.getByRole('button', { name: 'Play thud.wav' }).click();
  await expect(card.getByRole('button', { name: 'Pause thud.wav' })).toBeVisible();
  await expect(card.getByRole('button', { name: 'Play thud.wav' })).toBeVisible();

  await addObject(page, 'Mesh', 'Sphere');
  await addComponent(page, 'light');
  await addComponent(page, 'audio source');
  const source = page.getByRole('region', { name: 'Audio Source', exact: true });
  await source.getByRole('combobox', { name: 'Sound', exact: true }).click();
  await page.getByRole('option', { name: 'thud.wav' }).click();
  await source.getByLabel('Play on start', { exact: true }).click();
  await source.getByLabel('Loop', { exact: true }).click();
  for (const [i, method] of ['Light.toggle', 'AudioSource.play'].entries()) {
    await addComponent(page, 'event trigger');
    const trigger = page.getByRole('region', { name: 'Event Trigger', exact: true }).nth(i);
    await trigger.getByRole('combobox', { name: 'Call', exact: true }).click();
    await page.getByRole('combobox', { name: 'Search: Call' }).fill(method);
    await page.getByRole('option', { name: method }).click();
  }
  // the second one by a key, taken by pressing it
  const second = page.getByRole('region', { name: 'Event Trigger', exact: true }).nth(1);
  await second.getByRole('combobox', { name: 'Event', exact: true }).click();
  await page.getByRole('option', { name: 'Key down' }).click();
  await second.getByRole('button', { name: 'Press the key for Key' }).click();
  await page.keyboard.press('k');
  await expect(second.getByRole('combobox', { name: 'Key', exact: true })).toHaveText('K');
  expect((await history(page)).at(-1)).toBe('Set key of Sphere to “KeyK”');

  const before = await serialized(page);
  await page.keyboard.press('Control+p');
  const { x, y } = await pointOf(page, 'Sphere');
  await page.mouse.click(x, y);
  await expect.poll(() => lampOf(page)).toEqual([false, 0]);
  await page.mouse.click(x, y);
  await expect.poll(() => lampOf(page)).toEqual([true, 0]);
  await page.mouse.click(x, y);
  await page.keyboard.press('k');
  await expect.poll(() => lampOf(page)).toEqual([false, 1]);
  await page.getByRole('button', { name: /^Stop/ }).click();
  expect(await lampOf(page)).toEqual([true, 0]);
  expect(await serialized(page)).toBe(before);
  expect(await fieldOf(page, 'Sphere', 'AudioSource', 'sound')).toBe('thud.wav');
  await page.evaluate(() => (Reflect.get(window, 'putBack') as () => void)());
});
