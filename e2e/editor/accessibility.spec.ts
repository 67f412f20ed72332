import type { Page } from '@playwright/test';
import { expect, test } from '../support/test';
import { axeProblems } from './axe';
import { addObject, openEditor } from './editor';

test.use({ viewport: { width: 1000, height: 560 }, reducedMotion: 'reduce' });

// what a theme can change is the colours
const themes = { dark: undefined, light: ['color-contrast'] } as const;

for (const [theme, rules] of Object.entries(themes)) {
  test(`axe finds nothing serious, ${theme} theme`, async ({ page }) => {
    await page.addInitScript((value) => {
      localStorage.setItem('farol-editor', JSON.stringify({ state: { theme: value }, version: 0 }));
    }, theme);
    await openEditor(page, 'empty');
    expect(await axeProblems(page, rules)).toEqual([]);
    await addObject(page, 'Light', 'Spot light');
    expect(await axeProblems(page, rules)).toEqual([]);
    await page.getByRole('button', { name: 'Add', exact: true }).click();
    await expect(page.getByRole('menuitem', { name: 'Mesh' })).toBeVisible();
    expect(await axeProblems(page, rules)).toEqual([]);
    await page.keyboard.press('Escape');
    await page.getByRole('button', { name: 'Keys' }).click();
    await expect(page.getByRole('dialog', { name: 'Keys' })).toBeVisible();
    expect(await axeProblems(page, rules)).toEqual([]);
    // the journeys of these panels ask axe in the dark theme
    if (theme === 'light') await lookAtPanels(page, rules);
  });
}

/** The palette, and the panels that are behind others at first. */
async function lookAtPanels(page: Page, rules?: readonly string[]): Promise<void> {
  await page.keyboard.press('Escape');
  await page.keyboard.press('Control+k');
  await expect(page.getByRole('option').first()).toBeVisible();
  expect(await axeProblems(page, rules)).toEqual([]);
  await page.keyboard.press('Escape');
  await expect(page.getByRole('dialog')).toHaveCount(0);
  for (const name of ['Frame', 'Microshaders']) {
    await page.getByRole('tab', { name }).click();
    await expect(page.getByRole('region', { name, exact: true })).toBeVisible();
  }
  await page.evaluate(() => window.editor.notices.show('error', 'Something is wrong.'));
  expect(await axeProblems(page, rules)).toEqual([]);
  await page.getByRole('tab', { name: 'Console' }).click();
  await expect(page.getByRole('region', { name: 'Console' })).toContainText('Something is wrong.');
  expect(await axeProblems(page, rules)).toEqual([]);
}
