import type { Locator, Page } from '@playwright/test';
import { drop } from '../support/drop';
import { addObject, fieldOf, history, inspectorFollows } from './editor';
import { expect, test } from './sharedEditor';

test.use({ viewport: { width: 1280, height: 640 } });

const position = (page: Page, object: string): Promise<unknown> => fieldOf(page, object, 'Transform', 'position');

async function enter(input: Locator, text: string): Promise<void> {
  await input.fill(text);
  await input.press('Enter');
}

/** Presses and drags to the right; the button stays down. @param at - part of the width @param by - CSS pixels */
async function drag(page: Page, handle: Locator, at: number, by: number): Promise<void> {
  await handle.scrollIntoViewIfNeeded();
  // once the mouse is free again, and the handle stands still
  let before = '';
  await expect
    .poll(async () => {
      const last = before;
      before = await handle.evaluate((element) => JSON.stringify(element.getBoundingClientRect()));
      return last === before && (await page.evaluate(() => document.pointerLockElement === null));
    })
    .toBe(true);
  const { x, y, width, height } = (await handle.boundingBox())!;
  await page.mouse.move(x + width * at, y + height / 2);
  await page.mouse.down();
  for (const part of [0.5, 1]) await page.mouse.move(x + width * at + by * part, y + height / 2);
}

test('numbers take what people type, say why they do not, and give the keys back', async ({ page }) => {
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
  await inspectorFollows(page);
  await enter(y, '+=0.5');
  await enter(y, '*=2');
  expect(await position(page, 'Box')).toEqual([0, 1.6, 1.5]);
  expect(await position(page, 'Sun')).toHaveProperty('1', 2 * (8 + 0.5));

  // the name is selected when it is renamed: what is typed takes its place
  await page.getByRole('treeitem', { name: 'Sun' }).click();
  await inspectorFollows(page);
  await page.keyboard.press('F2');
  await page.keyboard.type('Lamp');
  await page.keyboard.press('Enter');
  expect((await history(page)).at(-1)).toBe('Renamed Sun to Lamp');
  // a name that is left by a click stays, and the focus is where the click was
  await page.keyboard.press('F2');
  await page.keyboard.type('Nobody');
  await y.click();
  await expect(page.getByLabel('Name of Lamp')).toHaveCount(0);
  await expect(y).toBeFocused();

  // labels and sliders are dragged, one step each; Escape takes a drag back
  const light = page.getByRole('region', { name: 'Light', exact: true });
  await light.getByRole('combobox', { name: 'Type' }).click();
  const ofIntensity = light.locator('[data-field="intensity"]');
  await expect(ofIntensity, 'a sun is in lux').toContainText(/lx$/);
  await page.getByRole('option', { name: 'Spot' }).click();
  await expect(ofIntensity, 'a lamp in candela').toContainText(/cd$/);
  const before = await history(page);
  const intensity = light.locator('[data-field="intensity"] .field-name');
  await drag(page, intensity, 0.5, 30);
  await page.keyboard.press('Escape');
  await page.mouse.up();
  expect(await fieldOf(page, 'Lamp', 'Light', 'intensity')).toBe(2);
  expect(await history(page)).toEqual(before);
  await drag(page, intensity, 0.5, 30);
  await page.mouse.up();
  expect(await history(page)).toEqual([...before, 'Set intensity of Lamp to 5']);
  await drag(page, light.locator('[data-field="penumbra"] .slider'), 0.2, 400);
  await page.mouse.up();
  expect((await history(page)).slice(before.length + 1)).toEqual(['Set penumbra of Lamp to 1']);

  // every label is read whole, and every number of the transform
  const cut = await page.evaluate(() =>
    [...document.querySelectorAll('.inspector :is(.field-label, .field-name, .input)')]
      .filter(({ scrollWidth, clientWidth }) => scrollWidth > clientWidth)
      .map(({ textContent, outerHTML }) => textContent || outerHTML),
  );
  expect(cut).toEqual([]);

  // a group folds, and stays so; the box finds what is in it
  const bias = light.getByLabel('Shadow bias');
  await expect(bias).toHaveCount(1);
  await light.getByRole('button', { name: 'Shadow', exact: true }).click();
  await expect(bias).toHaveCount(0);
  await page.getByRole('treeitem', { name: 'Sky' }).click();
  await page.getByRole('treeitem', { name: 'Lamp' }).click();
  await inspectorFollows(page);
  await expect(bias).toHaveCount(0);
  const find = page.getByRole('searchbox', { name: 'Find a field' });
  await find.fill('light bias');
  await expect(page.locator('.inspector [data-field]')).toHaveCount(2);
  await expect(page.getByRole('region', { name: 'Transform' })).toBeHidden();
  await find.fill('nothing like it');
  await expect(page.getByText('No field matches the search.')).toBeVisible();
  await find.press('Escape');
  await expect(page.getByRole('region', { name: 'Transform' })).toBeVisible();

  // nothing is dropped behind a dialog
  await page.keyboard.press('?');
  await expect(page.getByRole('dialog')).toBeVisible();
  const assets = await page.evaluate(() => window.editor.document.scene.assets.files.length);
  await drop(page, { 'triangle.obj': 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' });
  await page.keyboard.press('Escape');
  await expect(page.getByRole('dialog')).toHaveCount(0);
  expect(await page.evaluate(() => window.editor.document.scene.assets.files.length)).toBe(assets);
});
