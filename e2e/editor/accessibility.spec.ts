import AxeBuilder from '@axe-core/playwright';
import type { Page } from '@playwright/test';
import { expect, test } from '../support/test';
import { addObject, openEditor, openEmptyScene } from './editor';

test.use({ viewport: { width: 1000, height: 560 }, reducedMotion: 'reduce' });

/** What axe finds serious or critical. */
async function problems(page: Page): Promise<string[]> {
  const { violations } = await new AxeBuilder({ page }).analyze();
  return violations
    .filter(({ impact }) => impact === 'serious' || impact === 'critical')
    .flatMap(({ id, nodes }) => nodes.map(({ html, failureSummary }) => `${id}: ${html}\n${failureSummary}`));
}

for (const theme of ['dark', 'light'] as const) {
  test(`axe finds nothing serious, ${theme} theme`, async ({ page }) => {
    await page.addInitScript((value) => {
      localStorage.setItem('farol-editor', JSON.stringify({ state: { theme: value }, version: 0 }));
    }, theme);
    await openEditor(page);
    await openEmptyScene(page);
    expect(await problems(page)).toEqual([]);
    await addObject(page, 'Light', 'Spot light');
    expect(await problems(page)).toEqual([]);
    await page.getByRole('button', { name: 'Add', exact: true }).click();
    await expect(page.getByRole('menuitem', { name: 'Mesh' })).toBeVisible();
    expect(await problems(page)).toEqual([]);
    await page.keyboard.press('Escape');
    await page.getByRole('button', { name: 'Keys' }).click();
    await expect(page.getByRole('dialog', { name: 'Keys' })).toBeVisible();
    expect(await problems(page)).toEqual([]);
  });
}
