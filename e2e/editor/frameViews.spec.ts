import type { Light } from '@farol/engine';
import type { Page } from '@playwright/test';
import { addObject, history } from './editor';
import { expect, test } from './sharedEditor';

test.use({ viewport: { width: 840, height: 520 } });

const show = (page: Page, view: string): Promise<void> =>
  page.evaluate((name) => void (window.editor.viewport.view = name), view);

test('a view whose buffer is not there has a button that makes it; parts of a view are named; panes have views of their own @verify', async ({
  page,
  watch,
}) => {
  await addObject(page, 'Light', 'Spot light');
  const steps = (await history(page)).length;
  await show(page, 'motion');
  const lacking = page.getByRole('status').filter({ hasText: 'Motion is not in this frame' });
  await expect(lacking).toBeVisible();
  await lacking.getByRole('button', { name: 'Switch TAA on' }).click();
  const legend = page.getByRole('figure', { name: 'Motion' });
  await expect(legend).toContainText('Full colour: 16 pixels a frame and more');
  await expect(lacking).toHaveCount(0);
  expect((await history(page)).slice(steps)).toEqual(['Switch TAA on']);
  await page.keyboard.press('Control+z');
  await expect(lacking).toBeVisible();

  await page.evaluate(() => {
    for (const light of window.editor.document.scene.componentsOf<Light>('Light')) light.castShadow = true;
  });
  await show(page, 'shadow-atlas');
  const tiles = page.locator('.view-tile');
  await expect(tiles.filter({ hasText: 'Spot light' })).toHaveCount(1);
  const atlas = page.getByRole('figure', { name: 'Shadow atlas' });
  const box = (await tiles.filter({ hasText: 'Spot light' }).boundingBox())!;
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await expect(atlas).toContainText(/Spot light: Shadow map, [\d.]+ to [\d.]+ m/);
  await show(page, 'final');
  await expect(page.locator('.pane-overlay')).toHaveCount(0);

  await page.keyboard.press('Control+Alt+q');
  await page.evaluate(() => {
    const { viewport } = window.editor;
    viewport.shade(viewport.panes.list[0], 'view:light-count');
    viewport.shade(viewport.panes.list[1], 'view:froxels');
  });
  await expect(page.getByRole('figure', { name: /^Scale/ })).toHaveCount(1);
  await expect(page.getByRole('status').filter({ hasText: 'Volumetric fog is not in this frame' })).toHaveCount(1);
  expect(await page.evaluate(() => window.editor.viewport.view)).toBe('final');
  await page.keyboard.press('Control+Alt+q');
  expect(watch.forgive(/shows the final picture/)).toBe(2);
});
