import { expect, test } from '../support/test';
import { axeProblems } from './axe';
import { addObject, openEditor, openEmptyScene } from './editor';

test.use({ viewport: { width: 1000, height: 560 }, reducedMotion: 'reduce' });

for (const theme of ['dark', 'light'] as const) {
  test(`axe finds nothing serious, ${theme} theme`, async ({ page }) => {
    await page.addInitScript((value) => {
      localStorage.setItem('farol-editor', JSON.stringify({ state: { theme: value }, version: 0 }));
    }, theme);
    await openEditor(page);
    await openEmptyScene(page);
    expect(await axeProblems(page)).toEqual([]);
    await addObject(page, 'Light', 'Spot light');
    expect(await axeProblems(page)).toEqual([]);
    await page.getByRole('button', { name: 'Add', exact: true }).click();
    await expect(page.getByRole('menuitem', { name: 'Mesh' })).toBeVisible();
    expect(await axeProblems(page)).toEqual([]);
    await page.keyboard.press('Escape');
    await page.getByRole('button', { name: 'Keys' }).click();
    await expect(page.getByRole('dialog', { name: 'Keys' })).toBeVisible();
    expect(await axeProblems(page)).toEqual([]);
  });
}
