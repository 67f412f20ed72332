import type { Page } from '@playwright/test';
import type { Mesh, MeshStandardMaterial, PointLight } from 'three';
import { axeProblems } from '../support/axeProblems';
import { openExample } from '../support/example';
import { expect, test } from '../support/test';

async function open(page: Page, name: string): Promise<void> {
  await openExample(page, name);
  await page.setViewportSize({ width: 640, height: 400 });
}

/** The picture, beside the panels. */
const picture = (page: Page) => page.screenshot({ clip: { x: 0, y: 60, width: 320, height: 330 } });
const row = (page: Page, name: string) => page.getByRole('treeitem', { name }).first();

test('on a page that knows nothing of Farol: select, edit, undo', async ({ page }) => {
  await open(page, 'attach');
  const x = () => page.evaluate(() => window.example.scene!.getObjectByName('chest')!.position.x);
  const before = await picture(page);

  await row(page, 'chest').hover();
  await page.mouse.down();
  await page.evaluate(() => (window.example.scene!.getObjectByName('lantern 1')!.name = 'lamp')); // while it is pressed
  await expect(row(page, 'lamp')).toBeVisible();
  await page.mouse.up();
  await expect(row(page, 'chest')).toHaveAttribute('aria-selected', 'true');
  await page.evaluate(() => (window.example.scene!.getObjectByName('lamp')!.name = 'lantern 1'));
  const input = page.getByRole('spinbutton', { name: 'Position x' });
  await expect(input).toHaveValue('-2');
  await input.fill('0.5');
  expect(await x()).toBe(0.5); // a preview, which Escape takes back
  await input.press('Escape');
  expect(await x()).toBe(-2);
  await input.fill('50q');
  await input.press('Enter'); // no number: it stays, marked, with the reason
  await expect(input).toHaveValue('50q');
  await expect(page.getByText('“q” is neither a unit nor a function.')).toBeVisible();
  expect(await x()).toBe(-2);
  await input.fill('50cm');
  await input.press('Enter');
  expect(await x()).toBe(0.5);
  expect((await picture(page)).equals(before)).toBe(false); // although the page draws no frames by itself
  await page.getByRole('button', { name: 'Undo' }).click();
  expect(await x()).toBe(-2);
  await expect(input).toHaveValue('-2');
  await page.keyboard.press('Control+y');
  expect(await x()).toBe(0.5);

  await page.getByLabel('Colour', { exact: true }).fill('#ff0000');
  const colour = () =>
    page.evaluate(() =>
      ((window.example.scene!.getObjectByName('chest') as Mesh).material as MeshStandardMaterial).color.getHex(),
    );
  expect(await colour()).toBe(0xff0000);
  // brighter than a screen shows, by a factor that another screen colour keeps; an angle, whose neighbours keep all digits
  const channels = () =>
    page.evaluate(() =>
      ((window.example.scene!.getObjectByName('chest') as Mesh).material as MeshStandardMaterial).color.toArray(),
    );
  await page.getByRole('spinbutton', { name: 'Colour intensity' }).fill('3');
  await page.keyboard.press('Enter');
  expect(await channels()).toEqual([3, 0, 0]);
  await page.getByLabel('Colour', { exact: true }).fill('#0000ff');
  expect(await channels()).toEqual([0, 0, 3]);
  const rotation = () => page.evaluate(() => window.example.scene!.getObjectByName('chest')!.rotation.toArray());
  await page.evaluate(() => void window.example.scene!.getObjectByName('chest')!.rotation.set(0.123456789, 0, 1e-7));
  await expect(page.getByRole('spinbutton', { name: 'Rotation x' })).toHaveValue('7.074');
  await page.getByRole('spinbutton', { name: 'Rotation y' }).fill('90');
  await page.keyboard.press('Enter');
  expect(await rotation()).toEqual([0.123456789, Math.PI / 2, 1e-7, 'XYZ']);
  expect(await page.evaluate(() => window.example.editor!.commands.history.slice(-3))).toEqual([
    ...[
      'Set colour of MeshPhysicalMaterial to #ff0000 × 3',
      'Set colour of MeshPhysicalMaterial to #0000ff × 3',
      'Set rotation of chest to 7.074, 90, 0°',
    ],
  ]);
  for (const label of [
    'Undo: Set rotation of chest to 7.074, 90, 0°',
    'Undo: Set colour of MeshPhysicalMaterial to #0000ff × 3',
  ]) {
    await expect(page.getByRole('button', { name: 'Undo' })).toHaveAttribute('title', label);
    await page.getByRole('button', { name: 'Undo' }).click();
  }
  expect([await rotation(), await channels()]).toEqual([
    [0.123456789, 0, 1e-7, 'XYZ'],
    [3, 0, 0],
  ]);
  await expect(row(page, 'chest')).not.toHaveClass(/hidden/);
  await page.getByLabel('Visible').first().uncheck();
  expect(await page.evaluate(() => window.example.scene!.getObjectByName('chest')!.visible)).toBe(false);
  await expect(row(page, 'chest')).toHaveClass(/hidden/);

  await page.getByRole('searchbox', { name: 'Search objects' }).fill('rn 1');
  await expect(page.getByRole('treeitem')).toHaveCount(11); // lantern 1, and 10 to 19
  await row(page, 'lantern 1').click();
  await page.getByRole('searchbox', { name: 'Search objects' }).fill('');
  await expect(row(page, 'lantern 1')).toHaveAttribute('aria-selected', 'true');
  await page.getByRole('spinbutton', { name: 'Intensity', exact: true }).fill('-3'); // not allowed: marked, not taken
  await expect(page.getByRole('spinbutton', { name: 'Intensity', exact: true })).toHaveAttribute(
    'aria-invalid',
    'true',
  );
  await page.getByRole('spinbutton', { name: 'Intensity', exact: true }).fill('9');
  await page.keyboard.press('Enter');
  const intensity = () =>
    page.evaluate(() => (window.example.scene!.getObjectByName('lantern 1') as PointLight).intensity);
  expect(await intensity()).toBe(9);
  await page.getByRole('button', { name: 'Undo' }).click();
  expect(await intensity()).toBe(5);

  // another language: what is selected, and the history, stay
  await page.getByRole('combobox', { name: 'Language' }).selectOption('Español');
  await expect(page.getByRole('combobox', { name: 'Idioma' })).toBeFocused();
  await expect(page.getByRole('spinbutton', { name: 'Intensidad', exact: true })).toHaveValue('5');
  await page.getByRole('button', { name: 'Rehacer' }).click();
  expect(await intensity()).toBe(9);
  await page.evaluate(() => (window.example.editor!.language = 'en'));
  await expect(page.getByRole('button', { name: 'Undo' })).toBeVisible();
});

test('sliders, labels that are dragged, a filter for fields, and the keys of the gizmo @verify', async ({ page }) => {
  await open(page, 'attach');
  const steps = () => page.evaluate(() => window.example.editor!.commands.history.length);
  await row(page, 'chest').click();
  const roughness = () =>
    page.evaluate(
      () => ((window.example.scene!.getObjectByName('chest') as Mesh).material as MeshStandardMaterial).roughness,
    );
  const number = page.getByRole('spinbutton', { name: 'Roughness', exact: true });
  const field = page.locator('.field').filter({ has: number });

  // a filter leaves what it finds
  const filter = page.getByRole('searchbox', { name: 'Find a field' });
  await filter.fill('rough');
  await expect(page.getByRole('spinbutton', { name: 'Position x' })).toBeHidden();
  await expect(number).toBeVisible();

  // a slider previews, and is one step
  const slider = field.locator('input[type="range"]');
  const before = await steps();
  await slider.fill('0.25');
  expect(await roughness()).toBe(0.25);
  await expect(number).toHaveValue('0.25');
  expect(await steps()).toBe(before + 1);

  // so is a drag of the label, which Escape takes back
  const label = (await field.locator('.label').boundingBox())!;
  const [x, y] = [label.x + 8, label.y + label.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 20, y, { steps: 4 });
  await expect(number).toHaveValue('0.45');
  expect(await roughness()).toBe(0.45);
  await page.keyboard.press('Escape');
  await page.mouse.up();
  expect([await roughness(), await steps()]).toEqual([0.25, before + 1]);
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x - 10, y, { steps: 2 });
  await page.mouse.up();
  expect([await roughness(), await steps()]).toEqual([0.15, before + 2]);

  await filter.fill('no such field');
  await expect(page.getByText('No field matches the search.')).toBeVisible();
  await filter.press('Escape');
  await expect(page.getByRole('spinbutton', { name: 'Position x' })).toBeVisible();

  // the keys of Farol's own editor, and not while one types
  for (const [key, name] of [
    ['e', 'Rotate'],
    ['r', 'Scale'],
    ['w', 'Move'],
  ]) {
    await page.keyboard.press(key);
    await expect(page.getByRole('button', { name, exact: true })).toHaveAttribute('aria-pressed', 'true');
  }
  const space = page.getByRole('button', { name: "Handles along the object's axes, not the world's" });
  const isLocal = await space.getAttribute('aria-pressed');
  await page.keyboard.press('x');
  await expect(space).not.toHaveAttribute('aria-pressed', isLocal!);
  await filter.fill('e');
  await expect(page.getByRole('button', { name: 'Move', exact: true })).toHaveAttribute('aria-pressed', 'true');
});

test('several objects at once: shared and mixed values, copies, deletion; drawn by Farol @verify', async ({ page }) => {
  await open(page, 'attach');
  await page.getByRole('searchbox', { name: 'Search objects' }).fill('lantern');
  await row(page, 'lantern 1').click();
  // what differs is shown as such, and stays as it is where nothing is typed
  const input = page.getByRole('spinbutton', { name: 'Position x' });
  const positions = () =>
    page.evaluate(() =>
      ['lantern 1', 'lantern 2'].map((name) => window.example.scene!.getObjectByName(name)!.position.toArray()),
    );
  const [one, two] = await positions();
  await row(page, 'lantern 2').click({ modifiers: ['Control'] });
  await expect(page.getByRole('treeitem', { selected: true })).toHaveCount(2);
  await expect(input).toHaveAttribute('placeholder', '—');
  await page.getByRole('spinbutton', { name: 'Position y' }).fill('4');
  await page.keyboard.press('Enter');
  expect(await positions()).toEqual([
    [one[0], 4, one[2]],
    [two[0], 4, two[2]],
  ]);
  await page.getByRole('button', { name: 'Undo' }).click();
  expect(await positions()).toEqual([one, two]);
  const colours = () =>
    page.evaluate(() =>
      ['lantern 1', 'lantern 2'].map((name) =>
        (window.example.scene!.getObjectByName(name) as PointLight).color.toArray(),
      ),
    );
  await page.evaluate(() => {
    (window.example.scene!.getObjectByName('lantern 1') as PointLight).color.setRGB(4, 2, 0);
    (window.example.scene!.getObjectByName('lantern 2') as PointLight).color.setRGB(0, 1, 0.5);
  });
  const brightness = page.getByRole('spinbutton', { name: 'Colour intensity', exact: true });
  await expect(brightness).toHaveAttribute('placeholder', '—');
  await page.getByLabel('Colour', { exact: true }).fill('#0000ff'); // each at its own intensity
  expect(await colours()).toEqual([
    [0, 0, 4],
    [0, 0, 1],
  ]);
  await page.keyboard.press('Control+z');
  await brightness.fill('2'); // each in its own hue
  expect(await colours()).toEqual([
    [2, 1, 0],
    [0, 2, 1],
  ]);
  await page.keyboard.press('Control+z'); // of an edit under way
  expect(await colours()).toEqual([
    [4, 2, 0],
    [0, 1, 0.5],
  ]);
  await expect(brightness).toHaveValue('');
  expect(await axeProblems(page)).toEqual([]);

  // copies and deletion
  const count = (name: string) =>
    page.evaluate((name) => window.example.scene!.getObjectsByProperty('name', name).length, name);
  await page.keyboard.press('Control+d');
  expect([await count('lantern 1'), await count('lantern 2')]).toEqual([2, 2]);
  await page.getByRole('tree').focus();
  await page.keyboard.press('Delete');
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  expect([await count('lantern 1'), await count('lantern 2')]).toEqual([1, 1]);
  await page.getByRole('button', { name: 'Delete' }).click();
  expect([await count('lantern 1'), await count('lantern 2')]).toEqual([0, 0]);
  await page.getByRole('button', { name: 'Undo' }).click();
  await expect(page.getByRole('treeitem', { selected: true })).toHaveCount(2);

  await page.getByRole('button', { name: 'Draw with Farol' }).click();
  await expect(page.getByLabel('Technique')).toHaveValue('auto');
  await page.getByLabel('Technique').selectOption('deferred');
  await expect(page.getByRole('cell', { name: 'g-buffer' })).toBeVisible();
  await page.getByLabel('View').selectOption('albedo');
  expect(await page.evaluate(() => window.example.farol.view)).toBe('albedo');
  expect(await axeProblems(page)).toEqual([]);
  await page.getByLabel('Technique').selectOption('three');
  expect(await page.evaluate(() => window.example.editor!.farol)).toBe(null);
});

test('the gizmo takes the pointer from the controls of the page, which have it beside the gizmo', async ({ page }) => {
  await page.setViewportSize({ width: 640, height: 400 });
  await page.goto('./examples/attach/index.html?still');
  await page.waitForFunction(() => 'example' in window);
  const state = () =>
    page.evaluate(() => {
      const { scene, camera } = window.example;
      const placeOf = (name: string) => scene!.getObjectByName(name)!.position.toArray();
      return { knot: placeOf('knot'), chest: placeOf('chest'), camera: camera!.position.toArray() };
    });
  const placeOf = (name: string) =>
    page.evaluate((name) => {
      const { scene, camera } = window.example;
      const { x, y } = scene!.getObjectByName(name)!.position.clone().project(camera!);
      return { x: ((x + 1) / 2) * innerWidth, y: ((1 - y) / 2) * innerHeight };
    }, name);
  const chest = await placeOf('chest');
  await page.mouse.click(chest.x, chest.y);
  await expect(row(page, 'chest')).toHaveAttribute('aria-selected', 'true');
  await row(page, 'knot').click();
  await page.evaluate(() => window.example.drawFrame!(1)); // the gizmo is on the picture now
  const drag = async (fromX: number, fromY: number) => {
    await page.mouse.move(fromX, fromY);
    await page.mouse.down();
    await page.mouse.move(fromX + 20, fromY);
    await page.mouse.move(fromX + 40, fromY);
    await page.mouse.up();
  };
  const before = await state();
  const knot = await placeOf('knot');
  await drag(knot.x - 44, knot.y); // the red arrow to the left
  const dragged = await state();
  expect(dragged.knot[0]).toBeGreaterThan(0.2);
  expect(dragged.knot[1]).toBe(before.knot[1]);
  expect(dragged.camera).toEqual(before.camera);
  await page.evaluate(() => window.example.editor!.commands.undo());
  expect((await state()).knot).toEqual(before.knot);

  // what was let go of has no handles, and what is selected has them where it is, though no frame has been drawn since
  await page.evaluate(() => (window.requestAnimationFrame = () => 0));
  await row(page, 'chest').click();
  const place = (await state()).chest;
  await drag(chest.x - 44, chest.y);
  expect((await state()).chest[0]).toBeGreaterThan(place[0] + 0.2);
  await page.evaluate(() => window.example.editor!.commands.undo());
  await drag(knot.x - 44, knot.y);
  expect(await state()).toMatchObject({ knot: before.knot, chest: place });
  expect((await state()).camera).not.toEqual(before.camera);
  await page.evaluate(() => (window.example.editor!.selected = null));
  await drag(knot.x - 44, knot.y);
  expect(await state()).toMatchObject({ knot: before.knot, chest: place });

  const turnedTo = (await state()).camera;
  await drag(60, 350);
  const turned = await state();
  expect(turned.knot).toEqual(before.knot);
  expect(turned.camera).not.toEqual(turnedTo);
});
