import type { Page } from '@playwright/test';
import { addObject } from './editor';
import { dropFiles, redBox } from './models';
import { expect, test } from './sharedEditor';

test.use({ viewport: { width: 1280, height: 800 } });

const open = (page: Page, id: string): Promise<void> =>
  page.evaluate((panel) => {
    const { layout } = window.editor as unknown as { layout: { open(id: string): void } };
    layout.open(panel);
  }, id);

test('what is at its default is folded, a material is not spread out, and Add component is in reach', async ({
  page,
}) => {
  await page.evaluate(() => window.editor.preferences.setState({ folded: {} }));
  const inspector = page.getByRole('region', { name: 'Inspector' });
  await expect(inspector).toContainText('settings of the whole scene');
  await expect(inspector.getByRole('button', { name: 'Fog' })).toHaveAttribute('aria-expanded', 'false');
  await expect(inspector.getByRole('button', { name: 'Picture', exact: true })).toHaveAttribute(
    'aria-expanded',
    'true',
  );
  await addObject(page, 'Mesh', 'Box');
  await page.evaluate(() => {
    const { scene, selectedObjects } = window.editor.document;
    const { types } = scene.registry;
    for (const name of ['Light', 'Camera', 'RandomMovement', 'Collider'])
      selectedObjects[0].addComponent(types.get(name)!);
  });
  await expect(inspector.getByRole('region', { name: 'Collider' })).toBeAttached();
  await expect(inspector.getByRole('combobox', { name: 'Add component' })).toBeInViewport({ ratio: 1 });
  const drawn = inspector.getByRole('region', { name: 'Object Renderer' });
  // open for what was just made, folded from the next step on
  await expect(drawn.getByRole('button', { name: 'Own material' })).toHaveAttribute('aria-expanded', 'true');
  await addObject(page, 'Light', 'Point light');
  await page.getByRole('treeitem', { name: 'Box' }).click();
  await expect(drawn.getByRole('button', { name: 'Own material' })).toHaveAttribute('aria-expanded', 'false');
  await expect(drawn.getByLabel('Roughness')).toHaveCount(0);
  await drawn.getByRole('button', { name: 'Own material' }).click();
  await expect(drawn.getByLabel('Roughness').first()).toBeVisible();
});

test('tabs that have no room show icons, not cut titles, and every panel can be maximised @verify', async ({
  page,
}) => {
  await open(page, 'bake');
  await expect(page.getByRole('region', { name: 'Baked light' })).toBeVisible();
  const cut = await page
    .locator('.tab > span')
    .evaluateAll((titles) =>
      titles
        .filter(({ scrollWidth, clientWidth }) => clientWidth > 1 && scrollWidth > clientWidth)
        .map((each) => each.textContent),
    );
  expect(cut).toEqual([]);
  await expect(page.getByRole('tab', { name: 'Inspector', exact: true })).toBeVisible();
  for (const name of ['Hierarchy', 'Viewport', 'Baked light', 'Assets']) {
    await page.getByRole('button', { name: `Maximise ${name}` }).click();
    const panel = page.getByRole('tabpanel', { name, exact: true });
    await expect.poll(async () => (await panel.boundingBox())?.width).toBe(1280);
    await page.getByRole('button', { name: 'Give the window back' }).click();
    await expect.poll(async () => (await panel.boundingBox())?.width).toBeLessThan(1000);
  }
});

test('panels of many lines open at a useful height, which the user may change for good @verify', async ({ page }) => {
  for (const id of ['scripts', 'timeline', 'microshaders']) {
    await page.evaluate(() => (window.editor as unknown as { layout: { reset(): void } }).layout.reset());
    await open(page, id);
    const panel = page.locator(`#panel-${id}`);
    await expect.poll(async () => (await panel.boundingBox())?.height).toBeGreaterThan(300);
  }
  const edge = page.locator('.dock-edge[data-direction="column"]').first();
  await edge.focus();
  for (let i = 0; i < 10; i++) await page.keyboard.press('ArrowDown');
  const sized = (await page.locator('#panel-microshaders').boundingBox())!.height;
  expect(sized).toBeLessThan(250);
  await open(page, 'scripts');
  await expect.poll(async () => (await page.locator('#panel-scripts').boundingBox())?.height).toBe(sized);
});

test('assets are under headings and have names of words; parts of an import are folded into its card @verify', async ({
  page,
}) => {
  const panel = page.getByRole('region', { name: 'Assets' });
  await expect(panel.locator('[data-asset="box"]')).toHaveText('Box');
  await dropFiles(page, '.assets-body', [redBox()]);
  await expect(panel.locator('[data-asset="box.glb"]')).toBeVisible();
  await expect(panel.locator('.assets-heading').first()).toHaveText('Of this scene');
  await expect(panel.locator('[data-asset^="box.glb/"]')).toHaveCount(0);
  const parts = panel.getByRole('button', { name: /^\d+ parts?$/ });
  await parts.click();
  await expect(parts).toHaveAttribute('aria-expanded', 'true');
  await expect(panel.locator('[data-asset^="box.glb/"]').first()).toBeVisible();
  await parts.click();
  await panel.getByLabel('Search assets').fill('box.glb mesh');
  await expect(panel.locator('[data-asset^="box.glb/"]').first()).toBeVisible();
});

test('the palette finds a field by its help, shows it in the inspector, and adds a component @verify', async ({
  page,
}) => {
  const search = page.getByRole('combobox', { name: 'Search commands' });
  await page.keyboard.press('Control+k');
  await search.fill('tone mapping');
  await page.getByRole('option', { name: 'Tone mapping' }).first().click();
  const inspector = page.getByRole('region', { name: 'Inspector' });
  await expect(inspector.getByRole('searchbox', { name: 'Find a field' })).toHaveValue('Tone mapping');
  await expect(inspector.locator('[data-field]')).toHaveCount(1);
  // all fields of what is selected next
  await addObject(page, 'Mesh', 'Box');
  await expect(inspector.locator('[data-field="position"]')).toBeVisible();
  await page.keyboard.press('Control+k');
  await search.fill('random movement');
  await page
    .getByRole('option', { name: /Random Movement/ })
    .first()
    .click();
  await expect.poll(() => page.evaluate(() => window.editor.commands.history.at(-1))).toContain('Random Movement');
});

test('the name of Farol opens the other apps @verify', async ({ page }) => {
  for (const name of ['Viewer', 'Lab']) {
    await page.getByRole('button', { name: 'Farol', exact: true }).click();
    const opened = page.waitForEvent('popup');
    await page.getByRole('menuitem', { name }).click();
    await expect.poll(async () => (await opened).url()).toBe(process.env[`FAROL_${name.toUpperCase()}_URL`]);
    await (await opened).close();
  }
});
