import type { ObjectRenderer } from '@farol/engine';
import { addObject, fieldOf, history, serialized } from './editor';
import { dropFiles, pixelAt, redBox } from './models';
import { fbxSquare } from './fbxSquare';
import { expect, test } from './sharedEditor';

test.use({ viewport: { width: 1280, height: 720 } });

const picture = '.viewport-place canvas';

test('a material is made of an object, edited, dropped on another, named, put into a folder, and asked about', async ({
  page,
}) => {
  await addObject(page, 'Mesh', 'Box');
  await addObject(page, 'Mesh', 'Sphere');
  await page.getByRole('treeitem', { name: 'Box' }).click();
  await page.getByRole('button', { name: 'Make material asset' }).click();
  const inspector = page.getByRole('region', { name: 'Inspector' });
  await expect(inspector.getByLabel('Name of the asset')).toHaveValue('Box material');

  // maps come with pictures, and a map of normals is offered those first
  await inspector.getByRole('combobox', { name: 'Normal map' }).click();
  await expect(page.getByRole('option').first()).toHaveText('Marble, normal map');
  await page.keyboard.press('Escape');
  await inspector.getByRole('combobox', { name: 'Colour map' }).click();
  await expect(page.getByRole('option', { name: 'Brick', exact: true }).locator('img')).toBeVisible();
  await page.getByRole('option', { name: 'Brick', exact: true }).click();
  await inspector.getByRole('button', { name: 'Placement of Colour map' }).click();
  await inspector.getByLabel('Repeat U').fill('3');
  await page.keyboard.press('Enter');

  // the ball turns by a drag
  const ball = inspector.getByRole('img', { name: 'A ball of this material' });
  const drawn = (): Promise<string> => ball.evaluate((canvas: HTMLCanvasElement) => canvas.toDataURL());
  await expect.poll(async () => (await drawn()).length).toBeGreaterThan(4000);
  const before = await drawn();
  await ball.hover();
  await page.mouse.down();
  await page.mouse.move(1200, 200, { steps: 3 });
  await page.mouse.up();
  await expect.poll(drawn).not.toBe(before);

  await page.getByRole('tab', { name: 'Assets' }).click();
  const card = page.locator('[data-asset="Box material"]');
  await expect(card.locator('img')).toBeVisible();
  await card.dragTo(page.getByRole('treeitem', { name: 'Sphere' }));
  await expect.poll(() => fieldOf(page, 'Sphere', 'ObjectRenderer', 'material')).toBe('Box material');
  const isShared = await page.evaluate(() => {
    const [one, two] = ['Box', 'Sphere'].map((name) => {
      const object = window.editor.document.scene.find(name)!;
      return (object.getComponent('ObjectRenderer') as ObjectRenderer).three!.material as {
        map?: { repeat: { x: number } };
      };
    });
    return one === two && one.map!.repeat.x === 3;
  });
  expect(isShared).toBe(true);

  // a folder, another name, and what uses it
  await page.getByRole('button', { name: 'New', exact: true }).click();
  await page.getByRole('menuitem', { name: 'New folder…' }).click();
  await page.getByRole('dialog').getByRole('textbox').fill('Walls');
  await page.keyboard.press('Enter');
  // room for the card and the folder at once
  await page.getByRole('button', { name: 'Maximise Assets' }).click();
  await expect(page.getByRole('button', { name: 'Give the window back' })).toBeVisible();
  await expect(card.locator('img')).toBeVisible();
  // a press hits the card, not its icon, which goes when its picture comes
  const hit = await card.evaluate((element) => {
    const { left, top, width } = element.getBoundingClientRect();
    return document.elementFromPoint(left + width / 2, top + 30) === element;
  });
  expect(hit).toBe(true);
  // both in view: a scroll between press and move would take the card away from under the pointer
  const folder = page.locator('.asset-folder[data-folder="Walls"]');
  await folder.scrollIntoViewIfNeeded();
  await card.dragTo(folder, { steps: 4 });
  await expect(card).toHaveCount(0);
  await page.getByRole('button', { name: 'Give the window back' }).click();
  await page.locator('.asset-folder[data-folder="Walls"]').click();
  await page.locator('[data-asset="Walls/Box material"]').click();
  await page.keyboard.press('F2');
  await page.getByRole('dialog').getByRole('textbox').fill('Brick');
  await page.keyboard.press('Enter');
  await expect.poll(() => fieldOf(page, 'Sphere', 'ObjectRenderer', 'material')).toBe('Walls/Brick');
  await inspector.getByRole('button', { name: 'Select 2 objects' }).click();
  await expect(page.getByRole('treeitem', { selected: true })).toHaveCount(2);
  await page.locator('[data-asset="Walls/Brick"]').click();
  const full = await serialized(page);
  await page.keyboard.press('Delete');
  const dialog = page.getByRole('dialog');
  await expect(dialog).toContainText('It is used in 2 places');
  await dialog.getByRole('button', { name: 'Delete' }).click();
  expect(await fieldOf(page, 'Box', 'ObjectRenderer', 'material')).toBeNull();
  await page.keyboard.press('Control+z');
  expect(await serialized(page)).toBe(full);
});

test('a model is unpacked into objects that look the same, in one step; an FBX comes in with its clip @verify', async ({
  page,
}) => {
  await dropFiles(page, picture, [redBox()]);
  await expect(page.getByRole('treeitem', { name: 'box' })).toHaveAttribute('aria-selected', 'true');
  await page.locator(picture).focus();
  await page.keyboard.press('f');
  // no handles over the picture
  await page.keyboard.press('q');
  const places = [0.5, 0.45, 0.55].map((x) => [x, 0.5] as const);
  const look = (): Promise<unknown> => Promise.all(places.map(([x, y]) => pixelAt(page, x, y)));
  let before = await look();
  await expect
    .poll(async () => {
      const last = JSON.stringify(before);
      before = await look();
      return JSON.stringify(before) === last;
    })
    .toBe(true);
  const text = await serialized(page);
  // its objects can be looked at before
  await page.getByRole('button', { name: 'Look inside' }).click();
  await expect(page.locator('.model-tree').getByText('Box', { exact: true })).toBeVisible();
  await page.getByRole('button', { name: 'Unpack' }).click();
  await expect.poll(() => history(page)).toContain('Unpacked box');
  expect(await fieldOf(page, 'Box', 'ObjectRenderer', 'material')).toBe('box/Red');
  expect(await history(page)).toHaveLength(3);
  await expect.poll(look).toEqual(before);
  await page.keyboard.press('Control+z');
  expect(await serialized(page)).toBe(text);

  await dropFiles(page, picture, [fbxSquare]);
  await expect(page.getByRole('treeitem', { name: 'square' })).toHaveAttribute('aria-selected', 'true');
  expect(await fieldOf(page, 'square', 'Animation', 'clip')).toBe('square.glb/clip-1-Rise');
  await page.getByRole('button', { name: 'Clear Clip' }).click();
  expect(await fieldOf(page, 'square', 'Animation', 'clip')).toBeNull();
  await page.getByRole('combobox', { name: 'Clip' }).click();
  await expect(page.getByRole('option')).toHaveText(['Rise (square.glb)']);
  await page.getByRole('option').click();
  expect(await fieldOf(page, 'square', 'Animation', 'clip')).toBe('square.glb/clip-1-Rise');
});
