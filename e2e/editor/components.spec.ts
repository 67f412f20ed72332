import { addObject, fieldOf, history, serialized } from './editor';
import { expect, test } from './sharedEditor';

// a small picture: the software rasteriser draws every pixel on the CPU
test.use({ viewport: { width: 900, height: 600 }, reducedMotion: 'reduce' });

test('edits several objects at once, and goes back with Escape', async ({ page }) => {
  await addObject(page, 'Light', 'Point light');
  await addObject(page, 'Light', 'Spot light');
  await page.getByRole('treeitem', { name: 'Point light' }).click({ modifiers: ['Control'] });
  const light = page.getByRole('region', { name: 'Light', exact: true });
  const intensities = (): Promise<unknown[]> =>
    Promise.all(['Point light', 'Spot light'].map((name) => fieldOf(page, name, 'Light', 'intensity')));
  const before = await intensities();
  const steps = await history(page);

  const intensity = light.getByLabel('Intensity', { exact: true });
  await expect(intensity).toHaveValue('');
  await intensity.fill('33');
  expect(await intensities()).toEqual([33, 33]);
  await page.keyboard.press('Escape');
  expect(await intensities()).toEqual(before);
  expect(await history(page)).toEqual(steps);

  await intensity.fill('44');
  await page.keyboard.press('Enter');
  expect(await intensities()).toEqual([44, 44]);
  expect(await history(page)).toEqual([...steps, 'Set intensity of 2 objects to 44']);

  // a drag over the colour picker: one step
  await light.getByRole('button', { name: 'Colour', exact: true }).click();
  const picker = (await page.locator('.react-colorful__saturation').boundingBox())!;
  await page.mouse.move(picker.x + 20, picker.y + 20);
  await page.mouse.down();
  for (let i = 1; i <= 5; i++) await page.mouse.move(picker.x + 20 + i * 12, picker.y + 20 + i * 8);
  await page.mouse.up();
  await page.keyboard.press('Escape');
  await expect
    .poll(() => history(page))
    .toEqual([...steps, 'Set intensity of 2 objects to 44', expect.stringMatching(/^Set colour of 2 objects to #/)]);
  // the last move and the end of a drag in one turn of the page, as when it is busy: the picker's change comes late
  await light.getByRole('button', { name: 'Colour', exact: true }).click();
  const dragged = await fieldOf(page, 'Spot light', 'Light', 'diffuse');
  await page.mouse.move(picker.x + 30, picker.y + 30);
  await page.mouse.down();
  await expect.poll(() => fieldOf(page, 'Spot light', 'Light', 'diffuse')).not.toEqual(dragged);
  const shown = await fieldOf(page, 'Spot light', 'Light', 'diffuse');
  await page.locator('.react-colorful__saturation').evaluate((element) => {
    const { left, top } = element.getBoundingClientRect();
    const at = { bubbles: true, clientX: left + 90, clientY: top + 60 };
    element.dispatchEvent(new MouseEvent('mousemove', { ...at, buttons: 1 }));
    element.dispatchEvent(new PointerEvent('pointerup', at));
    element.dispatchEvent(new MouseEvent('mouseup', at));
  });
  await expect.poll(() => fieldOf(page, 'Spot light', 'Light', 'diffuse')).not.toEqual(shown);
  await page.mouse.up();
  await page.keyboard.press('Escape');
  await expect
    .poll(() => history(page))
    .toEqual([
      ...steps,
      'Set intensity of 2 objects to 44',
      expect.stringMatching(/^Set colour of 2 objects to #/),
      expect.stringMatching(/^Set colour of 2 objects to #/),
    ]);
  // closed while a key of it is down: what is shown is kept
  await light.getByRole('button', { name: 'Colour', exact: true }).click();
  await page.getByRole('slider', { name: 'Hue' }).focus();
  await page.keyboard.down('ArrowRight');
  await page.keyboard.press('Escape');
  await expect(page.locator('.react-colorful')).toHaveCount(0);
  await page.keyboard.up('ArrowRight');
  await expect.poll(async () => (await history(page)).length).toBe(steps.length + 4);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  expect(await fieldOf(page, 'Spot light', 'Light', 'diffuse')).toEqual(dragged);
  expect(await fieldOf(page, 'Spot light', 'Light', 'diffuse')).not.toEqual([1, 1, 1]);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  expect(await intensities()).toEqual(before);
  expect(await fieldOf(page, 'Spot light', 'Light', 'diffuse')).toEqual([1, 1, 1]);
});

test('enables, resets and removes components', async ({ page }) => {
  await page.getByRole('treeitem', { name: 'Sun' }).click();
  const before = await serialized(page);
  const light = page.getByRole('region', { name: 'Light', exact: true });
  await light.getByRole('checkbox', { name: 'Light enabled' }).click();
  expect(await page.evaluate(() => window.editor.document.scene.find('Sun')!.getComponent('Light')!.enabled)).toBe(
    false,
  );
  await light.getByRole('button', { name: 'Light menu' }).click();
  await page.getByRole('menuitem', { name: /^Reset/ }).click();
  expect(await fieldOf(page, 'Sun', 'Light', 'type')).toBe('point');
  await light.getByRole('button', { name: 'Light menu' }).click();
  await page.getByRole('menuitem', { name: 'Remove' }).click();
  await expect(light).toHaveCount(0);
  expect(await history(page)).toEqual(['Switched off Light of Sun', 'Reset Light of Sun', 'Removed Light from Sun']);
  for (let i = 0; i < 3; i++) await page.keyboard.press('Control+z');
  await expect(light.getByRole('combobox', { name: 'Type' })).toHaveText('Directional');
  expect(await serialized(page)).toBe(before);

  // a key is taken by pressing it, by its place on the keyboard; Escape leaves it
  await page.getByRole('combobox', { name: 'Add component' }).click();
  await page.getByRole('combobox', { name: 'Search: Add component' }).fill('event trigger');
  await page.getByRole('option').first().click();
  const trigger = page.getByRole('region', { name: 'Event Trigger', exact: true });
  await trigger.getByRole('combobox', { name: 'Event', exact: true }).click();
  await page.getByRole('option', { name: 'Key down' }).click();
  for (const key of ['Escape', 'k']) {
    await trigger.getByRole('button', { name: 'Press the key for Key' }).click();
    await page.keyboard.press(key);
  }
  await expect(trigger.getByRole('combobox', { name: 'Key', exact: true })).toHaveText('K');
  expect((await history(page)).slice(-2)).toEqual(['Set event of Sun to keyDown', 'Set key of Sun to “KeyK”']);
});
