import type { Locator, Page } from '@playwright/test';
import { expect, test } from '../support/test';
import { axeProblemsInVerify as axeProblems } from '../support/axeProblems';
import { addObject, openEditor, serialized, waitUntilReady } from './editor';
import { dropFiles, redBox } from './models';

test.use({ viewport: { width: 1000, height: 620 }, reducedMotion: 'reduce' });

const welcome = (page: Page): Locator => page.getByRole('dialog', { name: 'Welcome to Farol' });

test('a fresh profile is welcomed over a ready scene; the tour leads to real controls and can be left', async ({
  page,
}) => {
  await page.goto('./');
  await waitUntilReady(page);
  await expect(welcome(page)).toBeVisible();
  expect(await page.evaluate(() => window.editor.document.scene.name)).toBe('Temple');
  const pictures = welcome(page).getByRole('region', { name: 'Samples' }).locator('img');
  await expect(pictures).toHaveCount(await page.evaluate(() => Object.keys(window.editor.samples).length));
  const widths = (): Promise<number[]> =>
    pictures.evaluateAll((images) => images.map((image) => (image as HTMLImageElement).naturalWidth));
  await expect.poll(async () => [...new Set(await widths())]).toEqual([640]);
  expect(await axeProblems(page)).toEqual([]);

  await page.getByRole('button', { name: 'Two-minute tour' }).click();
  const card = page.locator('.tour-card');
  await expect(card).toContainText('The picture');
  await expect(card).toBeFocused();
  await page.keyboard.press('ArrowRight');
  await expect(card).toContainText('Add things');
  const add = page.getByRole('button', { name: 'Add', exact: true });
  const [mark, control] = await Promise.all([page.locator('.tour-mark').boundingBox(), add.boundingBox()]);
  expect(mark!.x).toBeLessThan(control!.x);
  expect(mark!.x + mark!.width).toBeGreaterThan(control!.x + control!.width);
  // what it shows can be used meanwhile
  await add.click();
  await expect(page.getByRole('menuitem', { name: 'Light', exact: true })).toBeVisible();
  await page.keyboard.press('Escape');
  await expect(page.getByRole('menu')).toHaveCount(0);
  await card.getByRole('button', { name: 'Next' }).click();
  expect(await axeProblems(page, ['color-contrast'])).toEqual([]);
  for (let step = 4; step <= 9; step++) {
    await page.keyboard.press('ArrowRight');
    await expect(card).toContainText(`${step} of 9`);
    await expect(page.locator('.tour-mark')).toBeVisible();
  }
  await page.keyboard.press('Escape');
  await expect(card).toHaveCount(0);
});

test('the welcome opens what was worked on, offers what was not saved, and takes a model @verify', async ({
  context,
  page,
}) => {
  await openEditor(page, 'empty');
  await addObject(page, 'Mesh', 'Cone');
  const download = page.waitForEvent('download');
  await page.keyboard.press('Control+s');
  expect((await download).suggestedFilename()).toBe('Untitled.farol');
  const saved = await serialized(page);
  await addObject(page, 'Mesh', 'Torus');
  const work = await serialized(page);
  await page.waitForFunction(() => window.editor.autosave?.isUpToDate);
  await page.waitForFunction(async () => {
    const { databases } = indexedDB;
    return (await databases.call(indexedDB)).some(({ name }) => name === 'farol-recent');
  });
  await page.close({ runBeforeUnload: false });

  const next = await context.newPage();
  await next.goto('./?scene=empty&welcome=yes');
  await waitUntilReady(next);
  await expect(welcome(next)).toContainText('Unsaved work was found');
  expect(await axeProblems(next)).toEqual([]);
  await welcome(next).getByRole('button', { name: 'Recover' }).click();
  await expect(next.getByRole('treeitem', { name: 'Torus' })).toBeVisible();
  expect(await serialized(next)).toBe(work);

  // the file as it was saved, from the menu and from its card
  await next.keyboard.press('Control+z');
  await next.getByRole('menuitem', { name: 'File', exact: true }).click();
  await next.getByRole('menuitem', { name: 'Welcome…' }).click();
  await welcome(next).getByRole('button', { name: 'Untitled.farol', exact: true }).click();
  await next.getByRole('dialog').getByRole('button', { name: 'Don’t save' }).click();
  await expect(next.getByRole('treeitem', { name: 'Torus' })).toHaveCount(0);
  await expect(next.getByRole('treeitem', { name: 'Cone' })).toBeVisible();
  expect(await serialized(next)).toBe(saved);

  // a model begins an empty scene
  await next.getByRole('menuitem', { name: 'Help', exact: true }).click();
  await next.getByRole('menuitem', { name: 'Welcome…' }).click();
  await dropFiles(next, '.welcome', [redBox()]);
  await expect(welcome(next)).toHaveCount(0);
  await expect(next.getByRole('treeitem', { name: 'box' })).toBeVisible();
  await expect(next.getByRole('treeitem', { name: 'Cone' })).toHaveCount(0);

  // switched off, the welcome screen does not open at the next start
  await next.keyboard.press('Control+z');
  await next.getByRole('menuitem', { name: 'File', exact: true }).click();
  await next.getByRole('menuitem', { name: 'Welcome…' }).click();
  await welcome(next).getByRole('checkbox', { name: 'Show at start' }).uncheck();
  expect(
    await next.evaluate(() => JSON.parse(localStorage.getItem('farol-editor')!).state.showWelcome as boolean),
  ).toBe(false);
});
