import { byExtent } from '@farol/tools/extent';
import type { Page } from '@playwright/test';
import { expect, test } from '../support/test';
import { axeProblems } from '../support/axeProblems';
import { outOfReach } from '../support/outOfReach';
import { addObject, openEditor, pointOf } from './editor';
import { makeFingers, type Point } from './fingers';
import { test as shared } from './sharedEditor';

test.use({ viewport: { width: 1000, height: 560 }, reducedMotion: 'reduce' });

async function openTheme(page: Page, theme: 'dark' | 'light', rules?: readonly string[]): Promise<void> {
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
  await page.keyboard.press('Escape');
  await expect(page.getByRole('dialog')).toHaveCount(0);
}

// the journeys of the other panels ask axe in the dark theme
test('axe finds nothing serious, dark theme @verify', async ({ page }) => openTheme(page, 'dark'));

test.describe('on a tablet', () => {
  test.use({ viewport: { width: 820, height: 1180 }, hasTouch: true });

  test('fingers turn, move and choose @verify', async ({ page }) => {
    await openEditor(page, 'empty');
    await addObject(page, 'Light', 'Spot light');
    await useFingers(page);
  });

  test('axe finds nothing serious, light theme; everything is in reach on a telephone @verify', async ({ page }) => {
    // what a theme can change is the colours
    await openTheme(page, 'light', ['color-contrast']);
    await lookAtPanels(page, ['color-contrast']);
    await holdAsTelephone(page);
  });
});

shared(
  'nothing is out of reach, and axe finds nothing serious, from twice enlarged to a large screen @verify',
  async ({ page }) => {
    await page.evaluate(() => window.editor.document.selection.set([window.editor.document.scene.find('Sun')!.id]));
    const small = [[640, 360]];
    const all = [...small, [800, 600], [1440, 900], [2560, 1440]];
    for (const [width, height] of byExtent({ slice: small, verify: all })) {
      await page.setViewportSize({ width, height });
      await expect(page.locator('.sheet-tabs')).toHaveCount(width < 1000 ? 1 : 0);
      await reachEverything(page, `${width} x ${height}`);
      await askInBothThemes(page);
    }
  },
);

/** Asks axe about the page as it is, and about its colours in the other theme; leaves the theme as it was. */
async function askInBothThemes(page: Page): Promise<void> {
  expect(await axeProblems(page)).toEqual([]);
  const shown = await page.evaluate(() => document.documentElement.dataset.theme as 'dark' | 'light');
  const other = shown === 'dark' ? 'light' : 'dark';
  for (const theme of [other, shown] as const) {
    await page.evaluate((theme) => window.editor.preferences.setState({ theme }), theme);
    await expect(page.locator('html')).toHaveAttribute('data-theme', theme);
    if (theme === other) expect(await axeProblems(page, ['color-contrast'])).toEqual([]);
  }
}

/** Asks each panel that is in a tab, and the dialogs, whether every control in them can be pressed. */
async function reachEverything(page: Page, where: string): Promise<void> {
  for (const tab of await page.getByRole('tab').all()) {
    await tab.click();
    await page.locator(`#panel-${await tab.evaluate(({ id }) => id.slice('tab-'.length))} .panel`).waitFor();
    expect(await outOfReach(page), `${where}, ${await tab.innerText()}`).toEqual([]);
  }
  for (const kind of ['keys', 'export', 'welcome'] as const) {
    await page.evaluate((shown) => void window.editor.dialogs.show({ kind: shown, recovery: null }), kind);
    const dialog = page.getByRole('dialog');
    await expect(dialog.getByRole('heading').first()).toBeVisible();
    expect(await outOfReach(page), `${where}, ${kind}`).toEqual([]);
    await page.keyboard.press('Escape');
    await expect(dialog).toHaveCount(0);
  }
}

/** A telephone held upright: sheets one at a time, controls of the size of a finger, the names in the tree readable. */
async function holdAsTelephone(page: Page): Promise<void> {
  await page.setViewportSize({ width: 390, height: 844 });
  await expect(page.locator('.sheet-tabs')).toBeVisible();
  await reachEverything(page, '390 x 844');
  await askInBothThemes(page);
  await page.getByRole('tab', { name: 'Hierarchy' }).tap();
  const sun = page.getByRole('treeitem', { name: 'Sun' });
  const name = sun.locator('.row-name');
  expect(await name.evaluate(({ scrollWidth, clientWidth }) => scrollWidth <= clientWidth)).toBe(true);
  expect((await sun.boundingBox())!.height).toBeGreaterThanOrEqual(40);
  await page.getByRole('tab', { name: 'Inspector' }).tap();
  await expect(sun).toBeHidden();
  for (const each of await page.locator('.toolbar .button:visible, .viewport-bar .button:visible, .sheet-tab').all()) {
    const box = (await each.boundingBox())!;
    expect(box.height, await each.innerText()).toBeGreaterThanOrEqual(40);
  }
  // everything that can be done, from one button
  await page.getByRole('button', { name: 'Menus' }).tap();
  await page.getByRole('menuitem', { name: 'Help', exact: true }).tap();
  await page.getByRole('menuitem', { name: 'Welcome…' }).tap();
  await expect(page.getByRole('dialog', { name: 'Welcome to Farol' })).toBeVisible();
}

/** Offset of the editor's camera from its orbit target, and the target (m, rounded to millimetres). */
const view = (page: Page): Promise<{ from: number[]; target: number[]; distance: number }> =>
  page.evaluate(() => {
    const { camera, editorCamera } = window.editor.viewport;
    const target = editorCamera.target.toArray();
    const from = camera.matrixWorld.elements.slice(12, 15).map((each, i) => each - target[i]);
    const round = (each: number): number => Math.round(each * 1000) / 1000;
    return { from: from.map(round), target: target.map(round), distance: round(Math.hypot(...from)) };
  });

/** One finger orbits, two pan and zoom, a tap chooses, a long press opens a menu; with the handles off one draws a box. */
async function useFingers(page: Page): Promise<void> {
  const fingers = await makeFingers(page);
  const { x, y, width } = (await page.locator('.viewport-place').boundingBox())!;
  const at = (right: number, down: number): Point => [x + width / 2 + right, y + 330 + down];
  // rows, icons and menus
  const selected = (): Promise<string[]> =>
    page.evaluate(() => window.editor.document.selectedObjects.map(({ name }) => name));
  const sun = page.getByRole('treeitem', { name: 'Sun' });
  await sun.tap();
  await expect.poll(selected).toEqual(['Sun']);
  const light = await pointOf(page, 'Spot light');
  await fingers.press([light.x, light.y]);
  await fingers.lift();
  await expect.poll(selected).toEqual(['Spot light']);
  const row = (await sun.boundingBox())!;
  await fingers.press([row.x + 60, row.y + 10]);
  await expect(page.getByRole('menuitem', { name: /^Duplicate Ctrl/ })).toBeVisible();
  expect(await selected()).toEqual(['Sun']);
  await fingers.lift();
  await page.keyboard.press('Escape');
  await expect(page.getByRole('menu')).toHaveCount(0);

  // in the picture too, where it is then no drag and no click
  const atRest = await view(page);
  await fingers.press([light.x, light.y]);
  await expect(page.getByRole('menuitem', { name: /^Duplicate Ctrl/ })).toBeVisible();
  expect(await selected()).toEqual(['Spot light']);
  await fingers.move([light.x + 90, light.y + 20]);
  await fingers.lift();
  await page.getByRole('menuitem', { name: /^Duplicate Ctrl/ }).click();
  await expect(page.getByRole('treeitem', { name: 'Spot light' })).toHaveCount(2);
  expect(await view(page)).toEqual(atRest);
  await page.keyboard.press('Control+z');
  await expect(page.getByRole('menu')).toHaveCount(0);
  await fingers.press(at(-300, -120));
  await page.getByRole('menuitem', { name: 'Light' }).waitFor();
  expect(await selected()).toEqual([]);
  await fingers.lift();
  await page.keyboard.press('Escape');
  await expect(page.getByRole('menu')).toHaveCount(0);
  await expect(page.locator('.viewport canvas')).toBeFocused();

  // the handles of what is selected would take the finger
  await page.evaluate(() => window.editor.document.selection.set([]));
  const start = await view(page);

  await fingers.press(at(0, 0));
  await fingers.move(at(80, 0));
  await fingers.lift();
  await expect.poll(async () => (await view(page)).from).not.toEqual(start.from);
  const turned = await view(page);
  expect(turned.target).toEqual(start.target);
  expect(turned.distance).toBeCloseTo(start.distance, 2);

  await fingers.press(at(-40, 0), at(40, 0));
  await fingers.move(at(20, 60), at(100, 60));
  await fingers.lift();
  await expect.poll(async () => (await view(page)).target).not.toEqual(turned.target);
  const moved = await view(page);
  // the device tells of one finger after the other, so that they are nearer to each other now and then
  expect(Math.abs(moved.distance / start.distance - 1)).toBeLessThan(0.1);

  await fingers.press(at(-40, 0), at(40, 0));
  await fingers.move(at(-120, 0), at(120, 0));
  await fingers.lift();
  await expect.poll(async () => (await view(page)).distance).toBeLessThan(start.distance * 0.7);

  // with the handles off one finger draws a box, until there is a second one
  await page.getByRole('button', { name: 'Select', exact: true }).click();
  const before = await view(page);
  await fingers.press(at(-40, 0));
  await fingers.move(at(0, 40));
  await expect(page.locator('.select-box')).toBeVisible();
  await fingers.press(at(0, 40), at(80, 40));
  await expect(page.locator('.select-box')).toBeHidden();
  await fingers.move(at(0, 100), at(80, 100));
  await fingers.lift();
  await expect.poll(async () => (await view(page)).target).not.toEqual(before.target);

  // every tab and button of the bars is within the window
  for (const each of await page.locator('.tab, .toolbar .button:visible').all()) {
    const box = (await each.boundingBox())!;
    expect(box.x, await each.innerText()).toBeGreaterThanOrEqual(0);
    expect(box.x + box.width, await each.innerText()).toBeLessThanOrEqual(820);
    expect(box.height).toBeGreaterThanOrEqual(28);
  }
}

/** The palette, and the panels that are behind others at first. */
async function lookAtPanels(page: Page, rules?: readonly string[]): Promise<void> {
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
