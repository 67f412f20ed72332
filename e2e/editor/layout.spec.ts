import type { Locator, Page } from '@playwright/test';
import { test as own } from '../support/test';
import { openEditor } from './editor';
import { expect, test } from './sharedEditor';

const options = { viewport: { width: 1100, height: 600 }, reducedMotion: 'reduce' } as const;
test.use(options);
own.use(options);

const tab = (page: Page, name: string): Locator => page.getByRole('tab', { name, exact: true });
const panel = (page: Page, name: string): Locator => page.getByRole('tabpanel', { name, exact: true });

async function boxOf(locator: Locator): Promise<{ x: number; y: number; width: number; height: number }> {
  await expect(locator).toBeVisible();
  return (await locator.boundingBox())!;
}

own('panels are dragged, moved by keys, closed, opened, resized, and remembered', async ({ page }) => {
  await openEditor(page, 'empty');
  const inspector = await boxOf(panel(page, 'Inspector'));
  const canvas = await page.evaluateHandle(() => window.editor.viewport.canvas);

  // by the mouse: the hierarchy above the inspector
  const from = await boxOf(tab(page, 'Hierarchy'));
  await page.mouse.move(from.x + 20, from.y + 12);
  await page.mouse.down();
  await page.mouse.move(inspector.x + 100, inspector.y + 30, { steps: 4 });
  await expect(page.locator('.drop-mark')).toBeVisible();
  await page.mouse.up();
  const hierarchy = await boxOf(panel(page, 'Hierarchy'));
  expect(hierarchy.x).toBe(inspector.x);
  expect(hierarchy.y).toBe(inspector.y);
  expect((await boxOf(panel(page, 'Inspector'))).y).toBeGreaterThan(inspector.y + 100);
  expect((await boxOf(panel(page, 'Viewport'))).x).toBe(0);

  // by keys: on to the viewport's place, as a tab there, and back to the right
  await tab(page, 'Hierarchy').focus();
  await page.keyboard.press('Alt+Shift+ArrowLeft');
  await expect(tab(page, 'Hierarchy')).toBeFocused();
  await expect(panel(page, 'Viewport')).toBeHidden();
  expect((await boxOf(panel(page, 'Hierarchy'))).x).toBe(0);
  await page.keyboard.press('ArrowLeft');
  await expect(panel(page, 'Viewport')).toBeVisible();
  await expect(tab(page, 'Viewport')).toBeFocused();
  expect(await page.evaluate((before) => window.editor.viewport.canvas === before && before.isConnected, canvas)).toBe(
    true,
  );

  // an edge, by keys
  const edge = page.locator('[role="separator"][aria-orientation="vertical"]').first();
  const before = Number(await edge.getAttribute('aria-valuenow'));
  await edge.focus();
  await page.keyboard.press('ArrowLeft');
  await expect(edge).toHaveAttribute('aria-valuenow', String(before - 16));

  // closed, and opened from the menu
  await tab(page, 'History').click();
  await page.keyboard.press('Delete');
  await expect(tab(page, 'History')).toHaveCount(0);
  const positions = await boxOf(panel(page, 'Inspector'));
  await page.reload();
  await page.waitForFunction(() => 'editor' in window);
  await page.evaluate(() => window.editor.ready);
  await expect(panel(page, 'Viewport')).toBeVisible();
  await expect(tab(page, 'History')).toHaveCount(0);
  expect(await boxOf(panel(page, 'Inspector'))).toEqual(positions);
  await page.getByRole('menuitem', { name: 'View', exact: true }).click();
  await page.getByRole('menuitem', { name: 'Panels', exact: true }).press('ArrowRight');
  await page.getByRole('menuitemcheckbox', { name: 'History' }).click();
  await expect(panel(page, 'History')).toBeVisible();

  // space gives the viewport the window, and gives it back
  await page.locator('canvas').click();
  await page.keyboard.press('Space');
  await expect(panel(page, 'Inspector')).toBeHidden();
  expect((await boxOf(panel(page, 'Viewport'))).width).toBe(1100);
  await page.keyboard.press('Space');
  await expect(panel(page, 'History')).toBeVisible();
  await page.keyboard.press('F6');
  await expect(page.getByRole('tabpanel').and(page.locator(':focus'))).toHaveCount(1);
});

test('the history goes to any step', async ({ page }) => {
  await page.getByRole('treeitem', { name: 'Sun' }).click();
  for (let i = 0; i < 3; i++) await page.keyboard.press('Control+d');
  await tab(page, 'History').click();
  const steps = panel(page, 'History').getByRole('button');
  await expect(steps).toHaveCount(4);
  await steps.nth(1).click();
  expect(await page.evaluate(() => window.editor.commands.history.length)).toBe(1);
  await expect(steps.nth(1)).toHaveAttribute('aria-current', 'step');
  await steps.nth(3).click();
  expect(await page.evaluate(() => window.editor.commands.history.length)).toBe(3);
});
