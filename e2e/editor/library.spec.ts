import { expect, test } from './sharedEditor';
import { addObject, fieldOf, history, inspectorFollows, menuIsGone, openEmptyScene } from './editor';

// a small picture: the software rasteriser draws every pixel on the CPU
test.use({ viewport: { width: 1000, height: 700 } });

test('a lamp of the library is found, dragged into the picture, added by a key, and taken back', async ({ page }) => {
  await page.getByRole('tab', { name: 'Library' }).click();
  const library = page.getByRole('region', { name: 'Library' });
  await library.getByRole('searchbox', { name: 'Search the library' }).fill('outdoors floor');
  const card = library.getByRole('button', { name: 'Street lamp' });
  await expect(library.getByRole('listitem')).toHaveCount(5);
  await expect(card.locator('img')).toHaveJSProperty('complete', true);
  expect(await card.locator('img').evaluate((image: HTMLImageElement) => image.naturalWidth)).toBeGreaterThan(0);
  const canvas = page.locator('.viewport-place canvas').first();
  const { width, height } = (await canvas.boundingBox())!;
  await card.dragTo(canvas, { targetPosition: { x: width * 0.4, y: height * 0.75 } });
  await expect.poll(() => history(page)).toEqual(['Added Street lamp']);
  const dropped = (await fieldOf(page, 'Street lamp', 'Transform', 'position')) as number[];
  expect(dropped[1]).toBe(0);
  await inspectorFollows(page);
  await card.press('Enter');
  await expect.poll(() => history(page)).toEqual(['Added Street lamp', 'Added Street lamp 2']);
  const lights = (): Promise<number> => page.evaluate(() => window.editor.document.scene.componentsOf('Light').length);
  expect(await lights()).toBe(4);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  await expect.poll(() => history(page)).toEqual([]);
  expect([await lights(), await page.evaluate(() => window.editor.document.scene.roots.length)]).toEqual([2, 3]);

  // the palette has the items too
  await page.keyboard.press('Control+k');
  await page.getByRole('combobox', { name: 'Search commands' }).fill('chandelier');
  await page.keyboard.press('Enter');
  await expect.poll(() => history(page)).toEqual(['Added Chandelier']);
});

test(
  'a prefab of the user is kept in the library, and placed in another scene',
  { tag: '@verify' },
  async ({ page }) => {
    await addObject(page, 'Mesh', 'Box');
    await page.getByRole('menuitem', { name: 'Object', exact: true }).click();
    await page.getByRole('menuitem', { name: 'Make prefab' }).click();
    await menuIsGone(page);
    await page.locator('.assets [data-asset]').filter({ hasText: 'Box' }).first().click({ button: 'right' });
    await page.getByRole('menuitem', { name: 'Put into the library' }).click();
    await menuIsGone(page);
    await expect(page.getByText('Box is in the library now, for all scenes.')).toBeVisible();
    // the scene has changed: without a question, it is let go
    await page.evaluate(() => window.editor.commands.clear());
    await openEmptyScene(page);
    await page.getByRole('tab', { name: 'Library' }).click();
    const library = page.getByRole('region', { name: 'Library' });
    await library.getByRole('combobox', { name: 'Kind of item' }).click();
    await page.getByRole('option', { name: 'My own' }).click();
    const card = library.getByRole('button', { name: 'Box', exact: true });
    await expect(card.locator('img')).toHaveJSProperty('complete', true);
    await card.click();
    await expect.poll(() => history(page)).toEqual(['Added Box']);
    expect(await fieldOf(page, 'Box', 'ObjectRenderer', 'mesh')).toBe('box');
    await library.getByRole('button', { name: 'Remove Box from the library' }).click();
    await expect(card).toHaveCount(0);
  },
);
