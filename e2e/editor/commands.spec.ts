import { expect, test } from '../support/test';
import { history, openEditor } from './editor';

test.use({ viewport: { width: 1100, height: 600 }, reducedMotion: 'reduce' });

test('the palette finds what can be done, and does it', async ({ page }) => {
  await openEditor(page, 'empty');
  const search = page.getByRole('combobox', { name: 'Search commands' });
  const options = page.getByRole('option');

  // a technique, by its name
  await page.keyboard.press('Control+k');
  await expect(search).toBeFocused();
  await page.keyboard.type('tiled def');
  await expect(options.first()).toContainText('Tiled deferred');
  await page.keyboard.press('Enter');
  await expect(search).toHaveCount(0);
  await expect.poll(() => page.evaluate(() => window.editor.viewport.technique)).toBe('tiled-deferred');

  // something to add, chosen by the arrow keys; while a text field has the focus
  await page.getByRole('textbox', { name: 'Name of the scene' }).focus();
  await page.keyboard.press('Control+k');
  await search.fill('light add');
  await expect(options.nth(1)).toBeVisible();
  const second = await options.nth(1).locator('.palette-label').textContent();
  await page.keyboard.press('ArrowDown');
  await expect(options.nth(1)).toHaveAttribute('aria-selected', 'true');
  await page.keyboard.press('Enter');
  await expect.poll(() => history(page)).toEqual([`Added ${second}`]);

  // an object; Escape closes
  await expect(search).toHaveCount(0);
  await page.keyboard.press('Control+k');
  await search.fill('sun');
  await options.filter({ hasText: 'Select' }).click();
  await expect
    .poll(() => page.evaluate(() => window.editor.document.selectedObjects.map(({ name }) => name)))
    .toEqual(['Sun']);
  await expect(search).toHaveCount(0);
  await page.keyboard.press('Control+k');
  await page.keyboard.press('Escape');
  await expect(search).toHaveCount(0);
});

test('keys are chosen anew, clashes are told, and all of it is remembered and reset', async ({ page }) => {
  await openEditor(page, 'empty');
  const dialog = page.getByRole('dialog', { name: 'Keys' });
  const openKeys = async (): Promise<void> => {
    await page.getByRole('button', { name: 'Keys', exact: true }).click();
    await expect(dialog.getByRole('searchbox', { name: 'Search keys' })).toBeFocused();
  };
  await page.getByRole('treeitem', { name: 'Sun' }).click();
  await openKeys();
  await dialog.getByRole('searchbox', { name: 'Search keys' }).fill('duplicate');
  const row = dialog.locator('[data-action="edit.duplicate"]');

  // Escape ends listening, not the dialog; then a key that is another action's
  await row.getByRole('button', { name: 'Add a key' }).click();
  await page.keyboard.press('Escape');
  await expect(dialog).toBeVisible();
  await row.getByRole('button', { name: 'Add a key' }).click();
  await page.keyboard.press('h');
  await expect(row.getByRole('alert')).toContainText('“Hide”');
  await row.getByRole('button', { name: 'Take it over' }).click();
  await row.getByRole('button', { name: 'Take Ctrl+D from Duplicate' }).click();
  await expect(row.locator('kbd')).toHaveText(['H']);
  await dialog.getByRole('button', { name: 'Close' }).click();
  await expect(dialog).toHaveCount(0);

  await page.getByRole('treeitem', { name: 'Sun' }).first().focus();
  await page.keyboard.press('h');
  expect(await history(page)).toEqual(['Duplicated Sun']);
  await page.keyboard.press('Control+d');
  expect(await history(page)).toHaveLength(1);

  // nothing to recover
  await page.keyboard.press('Control+z');
  await expect.poll(() => page.evaluate(() => window.editor.autosave?.isUpToDate)).toBe(true);
  await page.reload();
  await page.waitForFunction(() => 'editor' in window);
  await page.evaluate(() => window.editor.ready);
  await openKeys();
  await expect(row.locator('kbd')).toHaveText(['H']);
  await expect(dialog.locator('[data-action="edit.hide"] kbd')).toHaveCount(0);
  await dialog.getByRole('button', { name: 'Reset all' }).click();
  await expect(row.locator('kbd')).toHaveText(['Ctrl+D']);
  await expect(dialog.locator('[data-action="edit.hide"] kbd')).toHaveText(['H']);
});
