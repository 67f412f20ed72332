import { addObject, fieldOf, history, pointOf, serialized } from './editor';
import { expect, test } from './sharedEditor';

// a small picture: the software rasteriser draws every pixel on the CPU
test.use({ viewport: { width: 720, height: 440 } });

test('a ring of coloured lights over a floor; a box is moved by a typed number, dropped and measured', async ({
  page,
}) => {
  await addObject(page, 'Mesh', 'Plane');
  await addObject(page, 'Mesh', 'Box');
  await addObject(page, 'Mesh', 'Box');
  const placeOf = (name: string) => fieldOf(page, name, 'Transform', 'position') as Promise<number[]>;
  expect([(await placeOf('Plane'))[1], (await placeOf('Box'))[1], (await placeOf('Box 2'))[1]]).toEqual([0, 0.5, 0.5]);
  expect((await placeOf('Box 2'))[0] - (await placeOf('Box'))[0], 'beside the first').toBeGreaterThan(1);

  // a drag of the middle handle, and a number for it
  const middle = await pointOf(page, 'Box 2');
  await page.mouse.move(middle.x, middle.y);
  await expect.poll(() => page.evaluate(() => window.editor.viewport.gizmo.isHot)).toBe(true);
  const from = await placeOf('Box 2');
  await page.mouse.down();
  await page.mouse.move(middle.x + 30, middle.y - 10, { steps: 2 });
  const readout = page.locator('.drag-readout');
  await expect(readout).toContainText(/X [+−]\d+\.\d\d+ m/);
  // along one axis by its letter, and with the letter again as before
  await page.keyboard.press('y');
  await expect(readout).toHaveText(/^Y [+−]\d+\.\d\d+ m$/);
  expect((await placeOf('Box 2')).map((value, i) => value === from[i])).toEqual([true, false, true]);
  await page.keyboard.press('Shift+Y');
  await expect(readout).toHaveText(/^X .*Z [^Y]*m$/);
  expect((await placeOf('Box 2'))[1]).toBe(from[1]);
  await page.keyboard.press('Shift+Y');
  await expect(readout).toContainText(/X .*Y .*Z /);
  for (const key of ['1', '/', '4', 'Tab', '6']) await page.keyboard.press(key);
  await expect(readout).toContainText('X 1/4 m');
  await page.keyboard.press('Enter');
  await page.mouse.up();
  await expect(readout).toHaveCount(0);
  const to = await placeOf('Box 2');
  expect(to.map((value, i) => Number((value - from[i]).toFixed(4)))).toEqual([0.25, 6, 0]);
  expect((await history(page)).length).toBe(4);

  await page.keyboard.press('End');
  await expect.poll(async () => (await placeOf('Box 2'))[1]).toBe(0.5);

  // from corner to corner
  await page.keyboard.press('m');
  const measured = page.getByRole('region', { name: 'Measure distance' });
  await expect(measured).toContainText('Click two points');
  const corner = (x: number): Promise<{ x: number; y: number }> =>
    page.evaluate((side) => {
      const { viewport, document } = window.editor;
      const place = document.scene.find('Box 2')!.transform.worldPosition;
      place.x += side;
      place.y += 0.5;
      place.z += 0.5;
      place.project(viewport.camera as never);
      const { left, top, width, height } = viewport.canvas.getBoundingClientRect();
      return { x: left + ((place.x + 1) / 2) * width, y: top + ((1 - place.y) / 2) * height };
    }, x);
  for (const [side, inwards] of [
    [-0.5, 3],
    [0.5, -3],
  ] as const) {
    const { x, y } = await corner(side);
    await page.mouse.click(x + inwards, y + 2);
  }
  await expect(measured).toContainText('1 m');
  await page.keyboard.press('Escape');
  await expect(measured).toHaveCount(0);

  await addObject(page, 'Light', 'Point light');
  const before = await serialized(page);
  const steps = await history(page);
  await page.keyboard.press('Shift+D');
  const box = page.getByRole('form', { name: 'Duplicate Point light' });
  await box.getByRole('combobox', { name: 'Where' }).click();
  await page.getByRole('option', { name: 'On a ring' }).click();
  await box.getByRole('combobox', { name: 'Colours' }).click();
  await page.getByRole('option', { name: 'All hues in turn' }).click();
  await box.getByLabel('Count').fill('30');
  await expect(box).toContainText('30 in all');
  await box.getByRole('button', { name: 'Duplicate' }).click();
  await expect(box).toHaveCount(0);
  const lights = (): Promise<string[]> =>
    page.evaluate(() => {
      const all = window.editor.document.scene.componentsOf('Light') as unknown as {
        type: string;
        diffuse: number[];
      }[];
      return all.filter(({ type }) => type === 'point').map(({ diffuse }) => diffuse.join());
    });
  expect((await lights()).length).toBe(30);
  expect(new Set(await lights()).size).toBe(30);
  expect(await history(page)).toEqual([...steps, 'Duplicated Point light 29 times']);
  await page.keyboard.press('Control+z');
  expect(await serialized(page)).toBe(before);

  // left by Escape: nothing stays
  await page.keyboard.press('Shift+D');
  await expect(box).toBeVisible();
  expect((await lights()).length).toBe(5);
  await page.keyboard.press('Escape');
  await expect(box).toHaveCount(0);
  expect(await serialized(page)).toBe(before);
  expect(await history(page)).toEqual(steps);
});
