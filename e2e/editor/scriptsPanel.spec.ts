import type { Locator, Page } from '@playwright/test';
import { addObject, history } from './editor';
import { expect, test } from './sharedEditor';

test.use({ viewport: { width: 1280, height: 800 } });

const panel = (page: Page): Locator => page.getByRole('region', { name: 'Scripts' });
const inspector = (page: Page): Locator => page.getByRole('region', { name: 'Inspector' });

/** Puts the cursor at the end of the first line with a text. */
async function goToEnd(page: Page, text: string): Promise<void> {
  await panel(page).locator('.cm-line', { hasText: text }).first().click();
  await page.keyboard.press('End');
}

test('a script is made from the inspector, typed with completion, its error told and mended, all undone', async ({
  page,
}) => {
  await addObject(page, 'Mesh', 'Box');
  const before = await history(page);

  // made with its component, in one step, and shown
  await inspector(page).getByRole('combobox', { name: 'Add component' }).click();
  await page.getByRole('combobox', { name: 'Search: Add component' }).fill('new script');
  await page.keyboard.press('Enter');
  await expect(panel(page).locator('.cm-content')).toContainText('export default class Script');
  expect(await history(page)).toEqual([...before, 'Made script Script for Box']);
  const speed = inspector(page).getByRole('textbox', { name: 'Speed' });
  await expect(speed).toHaveValue('1');

  // a field more, which the inspector has at once
  await goToEnd(page, "help: 'How fast it turns.'");
  await page.keyboard.press('Enter');
  await page.keyboard.insertText("height: number(2, { unit: 'm', help: 'How high it jumps.' }),");
  await expect(inspector(page).getByRole('textbox', { name: 'Height' })).toHaveValue('2');

  // completion, chosen by a key
  await goToEnd(page, 'rotateY');
  await page.keyboard.press('Enter');
  await page.keyboard.type('this.gameObject.');
  const offered = page.getByRole('listbox', { name: 'Completions' });
  await expect(offered.getByRole('option', { name: 'addComponent' })).toBeVisible({ timeout: 60_000 });
  await page.keyboard.type('obj');
  await expect(offered.getByRole('option')).toHaveCount(1);
  await page.keyboard.press('Enter');

  // an error of types, told at its line, and mended
  await page.keyboard.type(".position.y = 'high';");
  const errors = panel(page).getByRole('list', { name: 'Errors' });
  await expect(errors).toContainText("Type 'string' is not assignable to type 'number'.");
  await expect(panel(page).getByRole('status')).toHaveText('1 error');
  for (let i = 0; i < "'high';".length; i++) await page.keyboard.press('Backspace');
  await page.keyboard.type('this.height;');
  await expect(errors).toHaveCount(0);
  await expect(panel(page).locator('.cm-content')).toContainText('this.gameObject.object3D.position.y = this.height;');

  // what was typed is one step; the script and its component another
  await inspector(page).getByRole('heading', { name: 'Transform' }).click();
  expect((await history(page)).slice(before.length)).toEqual(['Made script Script for Box', 'Edited script Script']);
  await page.keyboard.press('Control+z');
  await expect(inspector(page).getByRole('textbox', { name: 'Height' })).toHaveCount(0);
  await expect(panel(page).locator('.cm-content')).not.toContainText('this.height');
  await page.keyboard.press('Control+z');
  expect(await history(page)).toEqual(before);
  await expect(panel(page).getByRole('option')).toHaveCount(0);
  await expect(speed).toHaveCount(0);
});

test('a new script of the menu is of the selected objects, and what is typed next goes into it', async ({ page }) => {
  await addObject(page, 'Mesh', 'Box');
  const before = await history(page);
  await page.getByRole('menuitem', { name: 'Object', exact: true }).click();
  await page.getByRole('menuitem', { name: 'New script' }).click();
  await expect(panel(page).getByRole('textbox', { name: 'Text of the script' })).toBeFocused();
  // W, E and R would change the handles, Space would maximise the viewport
  await page.keyboard.type('// wheel rim\n');
  await expect(panel(page).locator('.cm-line').first()).toHaveText('// wheel rim');
  await expect(inspector(page).getByRole('textbox', { name: 'Speed' })).toBeVisible();
  expect((await history(page))[before.length]).toBe('Made script Script for Box');
});
