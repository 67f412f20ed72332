import type { Locator, Page } from '@playwright/test';
import { addObject, fieldOf, history, serialized } from './editor';
import { expect, test } from './sharedEditor';

test.use({ viewport: { width: 900, height: 520 } });

const region = (page: Page, name: string): Locator => page.getByRole('region', { name, exact: true });

async function fromMenu(page: Page, component: string, entry: string | RegExp): Promise<void> {
  await page.getByRole('button', { name: `${component} menu` }).click();
  await page.getByRole('menuitem', { name: entry }).click();
  await expect(page.getByRole('menu')).toHaveCount(0);
}

test('components are found by typing, ordered, copied and pasted; fields are reset', async ({ page }) => {
  await addObject(page, 'Mesh', 'Box');
  const before = await serialized(page);
  const add = async (words: string): Promise<void> => {
    await page.getByRole('combobox', { name: 'Add component' }).click();
    await page.getByRole('combobox', { name: 'Search: Add component' }).fill(words);
    await expect(page.getByRole('option')).toHaveCount(1);
    await page.keyboard.press('Enter');
    await expect(page.getByRole('listbox')).toHaveCount(0);
  };
  await add('random');
  await add('hemisphere');
  const components = (): Promise<string[]> =>
    page.evaluate(() => window.editor.document.scene.find('Box')!.components.map(({ typeName }) => typeName));
  await expect.poll(components).toEqual(['Transform', 'ObjectRenderer', 'RandomMovement', 'Light']);
  await fromMenu(page, 'Light', 'Move up');
  await expect.poll(components).toEqual(['Transform', 'ObjectRenderer', 'Light', 'RandomMovement']);

  const light = region(page, 'Light');
  await light.getByLabel('Intensity', { exact: true }).fill('7');
  await page.keyboard.press('Enter');
  await fromMenu(page, 'Light', 'Copy values');
  await page.getByRole('treeitem', { name: 'Sun' }).click();
  await fromMenu(page, 'Light', 'Paste values');
  const sun = (field: string) => expect.poll(() => fieldOf(page, 'Sun', 'Light', field));
  await sun('intensity').toBe(7);
  await sun('type').toBe('point');
  const intensity = light.locator('[data-field="intensity"]');
  await intensity.hover();
  await intensity.getByRole('button', { name: 'Reset to default' }).click();
  await sun('intensity').toBe(1);
  expect((await history(page)).slice(-3)).toEqual([
    'Set intensity of Box to 7',
    'Pasted values into Light of Sun',
    'Reset intensity of Sun',
  ]);
  for (let i = 0; i < 6; i++) await page.keyboard.press('Control+z');
  await expect.poll(() => serialized(page)).toBe(before);
});

test('several vectors show what they have in common; a material is seen as it is edited', async ({ page }) => {
  await addObject(page, 'Mesh', 'Box');
  await page.getByLabel('Position y').fill('2');
  await addObject(page, 'Mesh', 'Cone');
  await page.getByLabel('Position x').fill('5');
  await page.getByLabel('Position y').fill('2');
  await page.keyboard.press('Enter');

  // the colour in the middle of the ball
  const ball = page.getByRole('img', { name: 'A ball of this material' });
  const colour = (): Promise<number[]> =>
    ball.evaluate((canvas) =>
      [...(canvas as HTMLCanvasElement).getContext('2d')!.getImageData(96, 96, 1, 1).data].map((each) => each >> 6),
    );
  await expect.poll(async () => (await colour())[3]).toBe(3);
  const grey = await colour();
  expect(grey[0]).toBe(grey[2]);
  const shape = region(page, 'Object Renderer');
  await shape.getByRole('button', { name: 'Colour', exact: true }).click();
  await page.getByLabel('Colour as sRGB').fill('#0000ff');
  await page.keyboard.press('Enter');
  await page.keyboard.press('Escape');
  await expect.poll(async () => (await colour())[0]).toBe(0);
  expect((await colour())[2]).toBeGreaterThan(0);

  await page.getByRole('treeitem', { name: 'Box' }).click({ modifiers: ['Control'] });
  await expect(page.getByLabel('Position y')).toHaveValue('2');
  await expect(page.getByLabel('Position x')).toHaveValue('');
  await page.getByLabel('Position z').fill('-4');
  await page.keyboard.press('Enter');
  expect(await fieldOf(page, 'Cone', 'Transform', 'position')).toEqual([5, 2, -4]);
  expect(((await fieldOf(page, 'Box', 'Transform', 'position')) as number[]).slice(1)).toEqual([2, -4]);
});
