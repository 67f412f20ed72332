import type { Locator, Page } from '@playwright/test';
import { expect, test } from '../support/test';
import { addObject, fieldOf, history, openEditor } from './editor';

test.use({ viewport: { width: 1280, height: 640 }, reducedMotion: 'reduce' });

const position = (page: Page, object: string): Promise<unknown> => fieldOf(page, object, 'Transform', 'position');

async function enter(input: Locator, text: string): Promise<void> {
  await input.fill(text);
  await input.press('Enter');
}

test('numbers take what people type, say why they do not, and give the keys back', async ({ page }) => {
  await openEditor(page, 'empty');
  await addObject(page, 'Mesh', 'Box');
  const [x, y, z] = ['x', 'y', 'z'].map((axis) => page.getByLabel(`Position ${axis}`));
  await enter(x, '1/4');
  await enter(y, '30cm');
  await enter(z, '1,5');
  expect(await position(page, 'Box')).toEqual([0.25, 0.3, 1.5]);
  await enter(page.getByLabel('Rotation y'), 'pi/2 rad');
  expect(await fieldOf(page, 'Box', 'Transform', 'rotation')).toEqual([0, Math.PI / 2, 0]);

  // what is no number stays, and is not committed; Escape gives the value back and leaves
  const steps = (await history(page)).length;
  await enter(x, '1/3x');
  await expect(x).toHaveValue('1/3x');
  await expect(x).toHaveAttribute('aria-invalid', 'true');
  await expect(page.getByRole('alert')).toHaveText('“x” is neither a unit nor a function.');
  await y.focus();
  await expect(x).toHaveValue('1/3x');
  expect((await history(page)).length).toBe(steps);
  await x.press('Escape');
  await expect(x).toHaveValue('0.25');
  await expect(x).not.toBeFocused();
  expect(await position(page, 'Box')).toEqual([0.25, 0.3, 1.5]);

  // keys are hot keys again, after Escape as after Enter
  await enter(x, '-=.25');
  await page.keyboard.press('e');
  expect(await page.evaluate(() => window.editor.viewport.mode)).toBe('rotate');
  await page.keyboard.press('Control+a');
  await enter(y, '+=0.5');
  await enter(y, '*=2');
  expect(await position(page, 'Box')).toEqual([0, 1.6, 1.5]);
  expect(await position(page, 'Sun')).toHaveProperty('1', 2 * (8 + 0.5));
});
