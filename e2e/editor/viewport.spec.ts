import { expect, test } from '../support/test';
import { addObject, openEditor, pointOf } from './editor';

test.use({ viewport: { width: 900, height: 640 }, reducedMotion: 'reduce' });

test('selects by a box, from a side, without what is locked; shows what a camera sees', async ({ page }) => {
  await openEditor(page, 'empty');
  await addObject(page, 'Mesh', 'Box');
  await page.getByLabel('Position x').fill('-1');
  await addObject(page, 'Mesh', 'Cone');
  await page.getByLabel('Position x').fill('1');
  await page.keyboard.press('Enter');
  const selected = (): Promise<string[]> =>
    page.evaluate(() => window.editor.document.selectedObjects.map(({ name }) => name).toSorted());

  // from the front, by the cube
  await page.getByRole('button', { name: 'Look from the front' }).click({ force: true });
  await expect
    .poll(() => page.evaluate(() => window.editor.viewport.camera.matrixWorld.elements.slice(8, 11).map(Math.round)))
    .toEqual([0, 0, 1]);

  await page.keyboard.press('q');
  const [box, cone] = [await pointOf(page, 'Box'), await pointOf(page, 'Cone')];
  const drag = async (left: number, right: number): Promise<void> => {
    await page.mouse.move(left, box.y - 30);
    await page.mouse.down();
    await page.mouse.move(right, box.y + 30, { steps: 3 });
    await expect(page.locator('.select-box')).toBeVisible();
    await page.mouse.up();
    await expect(page.locator('.select-box')).toBeHidden();
  };
  await drag(box.x - 20, cone.x + 20);
  expect(await selected()).toEqual(['Box', 'Cone']);
  await drag(cone.x - 20, cone.x + 20);
  expect(await selected()).toEqual(['Cone']);
  await page.keyboard.down('Control');
  await drag(box.x - 20, box.x + 20);
  await page.keyboard.up('Control');
  expect(await selected()).toEqual(['Box', 'Cone']);

  await page.keyboard.press('l');
  await page.mouse.click(box.x, box.y);
  expect(await selected()).toEqual([]);

  // the small picture is of the background's colour, where the large one has the grid and the objects
  await page.getByRole('treeitem', { name: 'Camera' }).click();
  const look = page.getByRole('button', { name: 'Look through Camera' });
  await expect(look).toBeVisible();
  await look.click();
  await expect(page.getByRole('combobox', { name: 'Look through' })).toHaveText('Camera');
  await expect(look).toHaveCount(0);

  await page.getByRole('button', { name: 'Figures of the frames' }).click();
  await expect(page.getByRole('region', { name: 'Figures of the frames' })).toContainText('Triangles');
});
