import { addObject, pointOf } from './editor';
import { expect, test } from './sharedEditor';

test.use({ viewport: { width: 1120, height: 640 } });

test('selects by a box, from a side, without what is locked; shows what a camera sees', async ({ page }) => {
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
  await expect.poll(selected).toEqual(['Box', 'Cone']);
  await drag(cone.x - 20, cone.x + 20);
  expect(await selected()).toEqual(['Cone']);
  await page.keyboard.down('Control');
  await drag(box.x - 20, box.x + 20);
  await page.keyboard.up('Control');
  expect(await selected()).toEqual(['Box', 'Cone']);

  await page.keyboard.press('l');
  await page.mouse.click(box.x, box.y);
  expect(await selected()).toEqual([]);

  // ranges of lights: of the selected one, or of all
  await addObject(page, 'Light', 'Point light');
  await page.evaluate(() => window.editor.document.selection.set([]));
  const changed = await page.evaluate(() => {
    const { viewport } = window.editor;
    const gl = viewport.webgl.getContext() as WebGL2RenderingContext;
    const picture = (): Uint8Array => {
      viewport.renderNow();
      const pixels = new Uint8Array(gl.drawingBufferWidth * gl.drawingBufferHeight * 4);
      gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
      return pixels;
    };
    const before = picture();
    document.querySelector<HTMLButtonElement>('[aria-label^="Ranges of all lights"]')!.click();
    const after = picture();
    return after.filter((value, i) => value !== before[i]).length;
  });
  expect(changed).toBeGreaterThan(300);

  // steps of snapping, kept for the next time
  await page.getByRole('button', { name: 'Snap steps' }).click();
  await page.getByLabel('Distance of a snap step').fill('0.25');
  await page.getByLabel('Angle of a snap step').fill('90');
  await page.keyboard.press('Enter');
  await page.getByLabel('Scale of a snap step').fill('0.5');
  await page.keyboard.press('Escape'); // goes back
  await page.keyboard.press('Escape'); // closes
  const steps = await page.evaluate(() => window.editor.viewport.gizmo.snapSteps);
  expect(steps).toEqual({ translate: 0.25, rotate: Math.PI / 2, scale: 0.1 });
  expect(await page.evaluate(() => localStorage.getItem('farol-editor'))).toContain('"translate":0.25');
  await expect(page.getByRole('button', { name: 'Snap: 0.25 m, 90°, 0.1' })).toBeVisible();

  // the small picture is of the background's colour, where the large one has the grid and the objects
  await page.getByRole('treeitem', { name: 'Camera' }).click();
  const look = page.getByRole('button', { name: 'Look through Camera' });
  await expect(look).toBeVisible();
  await look.click();
  await expect(page.getByRole('combobox', { name: 'Look through' })).toHaveText('Camera');
  await expect(look).toHaveCount(0);

  await page.getByRole('button', { name: 'Frame statistics' }).click();
  await expect(page.getByRole('region', { name: 'Frame statistics' })).toContainText('Triangles');
});
