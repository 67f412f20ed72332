import { axeProblemsInVerify as axeProblems } from '../support/axeProblems';
import { fieldOf, history, serialized } from './editor';
import { expect, test } from './sharedEditor';

test.use({ viewport: { width: 1100, height: 600 } });

test('play, edit, stop: the scene is as it was, and values are kept one by one', async ({ page }) => {
  const before = await serialized(page);
  await page.keyboard.press('Control+p');
  await expect(page.getByRole('button', { name: 'Play' })).toHaveAttribute('aria-pressed', 'true');
  const mark = page.locator('.play-frame');
  await expect(mark).toContainText('Playing');
  await expect(page.locator('html')).toHaveAttribute('data-play', 'playing');
  expect(await axeProblems(page, ['color-contrast'])).toEqual([]);
  await page.getByRole('treeitem', { name: 'Sun' }).click();
  const light = page.getByRole('region', { name: 'Light', exact: true });
  await light.getByLabel('Intensity', { exact: true }).fill('5');
  await page.keyboard.press('Enter');
  await page.keyboard.press('Control+Shift+p');
  await expect.poll(() => page.evaluate(() => window.editor.document.simulation.state)).toBe('paused');
  await expect(mark).toContainText('Paused');
  const transform = page.getByRole('region', { name: 'Transform', exact: true });
  await transform.getByLabel('Position y').fill('9');
  await page.keyboard.press('Enter');
  await page.keyboard.press('Control+Alt+p');
  expect(await history(page)).toHaveLength(2);

  await page.getByRole('button', { name: /^Stop/ }).click();
  expect(await serialized(page)).toBe(before);
  expect(await history(page)).toEqual([]);
  await expect(mark).toHaveCount(0);
  await expect(page.locator('html')).not.toHaveAttribute('data-play');
  const kept = page.getByRole('region', { name: 'Edited while playing' });
  await expect(kept).toContainText('2 → 5');
  expect(await axeProblems(page)).toEqual([]);
  await kept.getByRole('button', { name: 'Keep intensity of Sun' }).click();
  expect(await fieldOf(page, 'Sun', 'Light', 'intensity')).toBe(5);
  expect(await history(page)).toEqual(['Kept intensity of Sun']);
  await expect(kept.getByRole('listitem')).toHaveCount(1);
  await page.keyboard.press('Control+z');
  expect(await serialized(page)).toBe(before);
  await kept.getByRole('button', { name: 'Keep all' }).click();
  expect(await history(page)).toEqual(['Kept the edits made while playing']);
  expect(await fieldOf(page, 'Sun', 'Transform', 'position')).toEqual([6, 9, 4]);
  await expect(kept).toHaveCount(0);
});
