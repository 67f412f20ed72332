import { readFile, writeFile } from 'node:fs/promises';
import { inflateRawSync } from 'node:zlib';
import type { Light } from '@farol/engine';
import { test as own } from '../support/test';
import { addObject, fieldOf, history, openEditor, openEmptyScene, pointOf, serialized, waitUntilReady } from './editor';
import { expect, test } from './sharedEditor';

// a small picture: the software rasteriser draws every pixel on the CPU
const options = { viewport: { width: 900, height: 600 }, reducedMotion: 'reduce' } as const;
test.use(options);
own.use(options);

/** The scene in a container: its first entry, by the local header's lengths of name and extra. @see APPNOTE.TXT 4.3.7 */
function sceneOf(zip: Buffer): string {
  const start = 30 + zip.readUInt16LE(26) + zip.readUInt16LE(28);
  expect(zip.subarray(30, 40).toString()).toBe('scene.json');
  return inflateRawSync(zip.subarray(start, start + zip.readUInt32LE(18))).toString();
}

own('opens the temple with its lights @verify', async ({ page }) => {
  await openEditor(page);
  const counts = await page.evaluate(() => ({
    lights: window.editor.document.scene.componentsOf<Light>('Light').filter(({ type }) => type === 'point').length,
    roots: window.editor.document.scene.roots.length,
    frames: window.editor.viewport.statistics.frames,
  }));
  expect(counts.lights).toBe(50);
  await expect(page.getByRole('treeitem')).toHaveCount(counts.roots);
  expect(counts.frames).toBeGreaterThan(0);
  await expect(page.getByRole('contentinfo', { name: 'Status' })).toContainText('58 lights');

  await openEmptyScene(page);
  await expect(page.getByRole('treeitem')).toHaveText(['Camera', 'Sun', 'Sky']);
});

own('add, edit, undo, redo, save, reload, open: the same scene', async ({ page }, info) => {
  await openEditor(page, 'empty');
  const empty = await serialized(page);

  await addObject(page, 'Mesh', 'Box');
  await expect(page.getByRole('treeitem', { name: 'Box' })).toHaveAttribute('aria-selected', 'true');

  await page.getByRole('combobox', { name: 'Add component' }).click();
  await page.getByRole('option', { name: /^Light (?!Group)/ }).click();
  const light = page.getByRole('region', { name: 'Light', exact: true });
  await expect(light).toBeVisible();

  // scrub: many values, one step
  const before = (await history(page)).length;
  const handle = light.locator('[data-field="intensity"] .number-handle');
  // parts of the light's section are fetched, and may take the row's place meanwhile
  await expect(async () => handle.scrollIntoViewIfNeeded()).toPass();
  const box = (await handle.boundingBox())!;
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  for (let i = 1; i <= 8; i++) await page.mouse.move(box.x + box.width / 2 + i * 5, box.y + box.height / 2);
  const dragged = (await fieldOf(page, 'Box', 'Light', 'intensity')) as number;
  expect(dragged).toBeGreaterThan(1);
  expect((await history(page)).length).toBe(before);
  await page.mouse.up();
  expect((await history(page)).length).toBe(before + 1);
  expect(await fieldOf(page, 'Box', 'Light', 'intensity')).toBe(dragged);
  await expect(light.getByLabel('Intensity', { exact: true })).toHaveValue(String(dragged));

  // undo works although the number has the focus, and the number follows
  await page.keyboard.press('Control+z');
  expect(await fieldOf(page, 'Box', 'Light', 'intensity')).toBe(1);
  await expect(light.getByLabel('Intensity', { exact: true })).toHaveValue('1');
  await page.keyboard.press('Control+y');
  expect(await fieldOf(page, 'Box', 'Light', 'intensity')).toBe(dragged);

  // typed, chosen, checked
  await light.getByLabel('Range').fill('7.25');
  await page.keyboard.press('Enter');
  await light.getByRole('combobox', { name: 'Type' }).click();
  await page.getByRole('option', { name: 'spot' }).click();
  await light.getByLabel('Cutoff angle').fill('40');
  await page.keyboard.press('Tab');
  expect(await fieldOf(page, 'Box', 'Light', 'cutoff')).toBeCloseTo((40 * Math.PI) / 180, 12);
  await light.getByLabel('Cast shadow').click();

  const file = info.outputPath('scene.farol');
  const download = page.waitForEvent('download');
  await page.keyboard.press('Control+s');
  await (await download).saveAs(file);
  const saved = await serialized(page);
  expect(sceneOf(await readFile(file))).toBe(saved);
  await expect.poll(() => page.evaluate(() => window.editor.commands.isDirty)).toBe(false);

  // all of it back, and again
  while (await page.evaluate(() => window.editor.commands.history.length)) await page.keyboard.press('Control+z');
  // the picture that saving made stays: it is no edit
  const { picture, ...undone } = JSON.parse(await serialized(page)) as Record<string, unknown>;
  expect(undone).toEqual(JSON.parse(empty));
  expect(picture).toBeTruthy();
  for (let i = 0; i < 7; i++) await page.keyboard.press('Control+Shift+z');
  expect(await serialized(page)).toBe(saved);

  // what is saved needs no recovery
  await expect.poll(() => page.evaluate(() => window.editor.autosave?.isUpToDate)).toBe(true);
  await page.reload();
  await waitUntilReady(page);
  expect(await serialized(page)).not.toBe(saved);
  const chooser = page.waitForEvent('filechooser');
  await page.getByRole('button', { name: /^Open/ }).first().click();
  await (await chooser).setFiles(file);
  await expect(page.getByRole('treeitem', { name: 'Box' })).toBeVisible();
  expect(await serialized(page)).toBe(saved);
  expect(await history(page)).toEqual([]);
});

test('picks in the picture, moves by the gizmo in one step, deletes and brings back', async ({ page }) => {
  await addObject(page, 'Mesh', 'Sphere');
  await page.keyboard.press('f');
  await page.keyboard.press('Escape');
  expect(await page.evaluate(() => window.editor.document.selection.ids)).toEqual([]);

  const middle = await pointOf(page, 'Sphere');
  await page.mouse.click(middle.x, middle.y);
  await expect(page.getByRole('treeitem', { name: 'Sphere' })).toHaveAttribute('aria-selected', 'true');

  // the handle of the x axis, where three draws it: 0.85 of a sixth of the picture's height, in perspective
  const from = (await fieldOf(page, 'Sphere', 'Transform', 'position')) as number[];
  const before = await serialized(page);
  const steps = await history(page);
  const start = await page.evaluate(() => {
    const { viewport, document } = window.editor;
    const { object3D } = document.scene.find('Sphere')!;
    const place = object3D.getWorldPosition(object3D.position.clone());
    const eye = place.clone().setFromMatrixPosition(viewport.camera.matrixWorld);
    const { fov } = viewport.camera as unknown as { fov: number };
    const size = (place.distanceTo(eye) * Math.min(1.9 * Math.tan((Math.PI * fov) / 360), 7) * 0.85) / 4;
    place.x += size * 0.4;
    place.project(viewport.camera as never);
    const { left, top, width, height } = viewport.canvas.getBoundingClientRect();
    return { x: left + ((place.x + 1) / 2) * width, y: top + ((1 - place.y) / 2) * height };
  });
  const along = { x: (start.x - middle.x) * 0.5, y: (start.y - middle.y) * 0.5 };
  await page.mouse.move(start.x, start.y);
  await page.waitForFunction(() => window.editor.viewport.gizmo.isHot);
  await page.mouse.down();
  for (let i = 1; i <= 5; i++) await page.mouse.move(start.x + (along.x * i) / 5, start.y + (along.y * i) / 5);
  await page.mouse.up();
  const to = (await fieldOf(page, 'Sphere', 'Transform', 'position')) as number[];
  expect(to[0]).toBeGreaterThan(from[0] + 0.05);
  expect(to.slice(1)).toEqual(from.slice(1));
  expect(await history(page)).toEqual([...steps, expect.stringMatching(/^Moved Sphere by [\d.]+, 0, 0 m$/)]);
  await page.keyboard.press('Control+z');
  expect(await serialized(page)).toBe(before);

  // the sphere stays selected: a drag is no click
  await page.keyboard.press('Delete');
  await expect(page.getByRole('treeitem', { name: 'Sphere' })).toHaveCount(0);
  await page.keyboard.press('Control+z');
  await expect(page.getByRole('treeitem', { name: 'Sphere' })).toHaveAttribute('aria-selected', 'true');
  expect(await serialized(page)).toBe(before);
});

test('picks a light by its icon, also for a menu, and a decal', async ({ page }) => {
  await addObject(page, 'Light', 'Point light');
  await page.keyboard.press('Escape');
  const icon = await pointOf(page, 'Point light');
  await page.mouse.click(icon.x + 5, icon.y - 5);
  const selected = () => page.evaluate(() => window.editor.document.selectedObjects.map(({ name }) => name));
  expect(await selected()).toEqual(['Point light']);
  await page.mouse.click(icon.x + 80, icon.y + 60, { button: 'right' });
  await expect(page.getByRole('menuitem', { name: 'Light' })).toBeVisible();
  expect(await selected()).toEqual([]);
  await page.keyboard.press('Escape');
  await page.mouse.click(icon.x + 5, icon.y - 5, { button: 'right' });
  await page.getByRole('menuitem', { name: 'Delete' }).click();
  await expect(page.getByRole('treeitem', { name: 'Point light' })).toHaveCount(0);

  await addObject(page, 'Decal');
  const decal = await pointOf(page, 'Decal');
  await page.mouse.move(decal.x, decal.y);
  await expect.poll(() => page.evaluate(() => window.editor.viewport.gizmo.isHot)).toBe(true);
  // what was let go of has no handles, though no frame has been drawn since
  await page.evaluate(async () => {
    const held: FrameRequestCallback[] = [];
    const real = window.requestAnimationFrame;
    window.requestAnimationFrame = (callback) => held.push(callback);
    window.addEventListener('release', () => {
      window.requestAnimationFrame = real;
      held.forEach((callback) => real(callback));
    });
    await new Promise((resolve) => real(resolve));
  });
  await page.evaluate(() => window.editor.document.selection.set([window.editor.document.scene.find('Sun')!.id]));
  await page.mouse.click(decal.x, decal.y);
  expect(await selected(), 'the handles are not yet where the sun is').toEqual(['Decal']);
  await page.keyboard.press('Escape');
  expect(await selected()).toEqual([]);
  await page.mouse.click(decal.x, decal.y);
  expect(await selected()).toEqual(['Decal']);
  await page.evaluate(() => window.dispatchEvent(new Event('release')));

  const roughness = page.getByLabel('Roughness', { exact: true });
  await expect(roughness).toBeVisible();
  await page.getByRole('combobox', { name: 'Blending' }).click();
  await page.getByRole('option', { name: 'multiply' }).click();
  expect(await fieldOf(page, 'Decal', 'Decal', 'blending')).toBe('multiply');
  await expect(roughness, 'is left to the surface').toHaveCount(0);
});

test('re-parents by keyboard, duplicates, renames and hides', async ({ page }) => {
  await addObject(page, 'Empty object');
  await page.keyboard.press('F2');
  await page.getByLabel('Name of Object').fill('Parent');
  await page.keyboard.press('Enter');
  await addObject(page, 'Mesh', 'Torus');
  const before = await serialized(page);

  // take it up, one place higher is on 'Parent'
  await page.getByRole('treeitem', { name: 'Torus' }).focus();
  await page.keyboard.press('Control+Shift+d');
  const parentOf = (): Promise<string | null> =>
    page.evaluate(() => window.editor.document.scene.find('Torus')!.parent?.name ?? null);
  for (let i = 0; i < 6; i++) {
    await page.keyboard.press('ArrowUp');
    const target = page.locator('.row.drop-target');
    if ((await target.count()) === 1 && (await target.getAttribute('aria-label')) === 'Parent') break;
  }
  await page.keyboard.press('Enter');
  expect(await parentOf()).toBe('Parent');
  await expect(page.getByRole('treeitem', { name: 'Torus' })).toHaveAttribute('aria-level', '2');
  await page.keyboard.press('Control+z');
  expect(await parentOf()).toBeNull();
  expect(await serialized(page)).toBe(before);

  await page.keyboard.press('Control+d');
  await expect(page.getByRole('treeitem', { name: 'Torus' })).toHaveCount(2);
  await page.keyboard.press('h');
  const [active] = await page.evaluate(() => window.editor.document.selectedObjects.map((object) => object.active));
  expect(active).toBe(false);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  expect(await serialized(page)).toBe(before);
});

test('re-parents by drag, where it stays in the world', async ({ page }) => {
  await addObject(page, 'Empty object');
  await page.getByLabel('Position x').fill('3');
  await page.getByLabel('Rotation y').fill('90');
  await page.keyboard.press('Enter');
  await addObject(page, 'Mesh', 'Cone');
  const world = (): Promise<number[]> =>
    page.evaluate(() => window.editor.document.scene.find('Cone')!.transform.worldPosition.toArray());
  const before = await world();
  await page.getByRole('treeitem', { name: 'Cone' }).dragTo(page.getByRole('treeitem', { name: 'Object' }));
  await expect(page.getByRole('treeitem', { name: 'Cone' })).toHaveAttribute('aria-level', '2');
  const after = await world();
  after.forEach((value, i) => expect(value).toBeCloseTo(before[i], 6));
  expect((await history(page)).at(-1)).toBe('Moved Cone into Object');
});

test('plays, pauses, steps and stops without a trace in the history', async ({ page }) => {
  await addObject(page, 'Mesh', 'Box');
  await page.getByRole('combobox', { name: 'Add component' }).click();
  await page.getByRole('option', { name: /^Random Movement/ }).click();
  const before = await serialized(page);
  const steps = await history(page);
  const time = (): Promise<number> => page.evaluate(() => window.editor.document.scene.time);
  const place = (): Promise<readonly number[]> =>
    page.evaluate(() => [...window.editor.document.scene.find('Box')!.transform.position]);
  const authored = await place();

  await page.keyboard.press('Control+p');
  await expect.poll(time).toBeGreaterThan(0.2);
  await page.keyboard.press('Control+Shift+p');
  const paused = await time();
  expect(await place()).not.toEqual(authored);
  await expect(page.getByText(/^now /)).toBeVisible();
  await page.getByRole('button', { name: /^Step by/ }).click();
  expect(await time()).toBeCloseTo(paused + 1 / 60, 6);
  await page.getByRole('button', { name: /^Stop/ }).click();
  expect(await time()).toBe(0);
  expect(await place()).toEqual(authored);
  expect(await serialized(page)).toBe(before);
  expect(await history(page)).toEqual(steps);
});

test('lists all that is wrong with a broken file, and keeps the scene', async ({ page }, info) => {
  await addObject(page, 'Mesh', 'Box');
  const before = await serialized(page);
  const file = JSON.parse(before) as {
    objects: { parent: string | null; components: { type: string; values: Record<string, unknown> }[] }[];
  };
  file.objects[0].components[0].values.position = ['a', 0, 0];
  file.objects[1].parent = 'nobody';
  file.objects.at(-1)!.components[1].values.mesh = 7;
  const path = info.outputPath('broken.json');
  await writeFile(path, JSON.stringify(file));

  const chooser = page.waitForEvent('filechooser');
  // what is broken is told of before anything is asked
  await page.keyboard.press('Control+o');
  await (await chooser).setFiles(path);
  const dialog = page.getByRole('dialog', { name: 'broken.json cannot be opened' });
  await expect(dialog.getByRole('listitem')).toHaveCount(3);
  await expect(dialog).toContainText('objects[0].components[0].values.position');
  await expect(dialog).toContainText('nobody');
  await expect(dialog).toContainText('components[1].values.mesh');
  await dialog.getByRole('button', { name: 'Close' }).click();
  expect(await serialized(page)).toBe(before);
  expect(await history(page)).toEqual(['Added Box']);

  // a component whose plugin is not there is kept as data, and told of
  const strange = JSON.parse(before) as typeof file;
  Object.assign(strange.objects.at(-1)!.components[1], { type: 'Teleporter', values: { to: 'the moon' } });
  await writeFile(path, JSON.stringify(strange));
  const again = page.waitForEvent('filechooser');
  await page.keyboard.press('Control+o');
  await (await again).setFiles(path);
  const question = page.getByRole('dialog', { name: 'Unsaved changes' });
  await question.getByRole('button', { name: 'Cancel' }).click();
  expect(await serialized(page)).toBe(before);
  expect(await page.evaluate(() => window.editor.commands.isDirty)).toBe(true);
  const third = page.waitForEvent('filechooser');
  await page.keyboard.press('Control+o');
  await (await third).setFiles(path);
  const download = page.waitForEvent('download');
  await question.getByRole('button', { name: 'Save', exact: true }).click();
  await (await download).cancel();
  await expect(page.locator('.notices')).toContainText('kept as data: Teleporter. Add the plugin');
  expect(JSON.parse(await serialized(page))).toEqual(strange);
});

test('switches technique and view', async ({ page }) => {
  // the inspector of the scene has the technique too
  const technique = page.locator('.toolbar').getByRole('combobox', { name: 'Technique' });
  await technique.click();
  await page.getByRole('option', { name: /^Forward, multipass/ }).click();
  await page.getByRole('combobox', { name: 'View' }).click();
  await page.getByRole('option', { name: 'Normal' }).click();
  expect(await page.evaluate(() => [window.editor.viewport.technique, window.editor.viewport.view])).toEqual([
    'forward',
    'normal',
  ]);
  await expect(technique).toHaveText(/Forward, multipass/);
});

test('flies while the right button is held, and only then', async ({ page }) => {
  const eye = (): Promise<number[]> =>
    page.evaluate(() => window.editor.viewport.camera.position.toArray().map((value) => Number(value.toFixed(4))));
  const before = await eye();
  await page.locator('canvas').hover({ position: { x: 160, y: 250 } });
  await page.keyboard.press('r');
  await page.keyboard.down('w');
  expect(await page.evaluate(() => window.editor.viewport.mode)).toBe('translate');
  await page.keyboard.up('w');
  expect(await eye()).toEqual(before);

  await page.keyboard.press('r');
  await page.mouse.down({ button: 'right' });
  await page.keyboard.down('w');
  await expect.poll(eye).not.toEqual(before);
  await page.keyboard.up('w');
  await page.mouse.up({ button: 'right' });
  await expect(page.getByRole('menu'), 'it was no click').toHaveCount(0);
  expect(await page.evaluate(() => window.editor.viewport.mode)).toBe('scale');
  expect(await history(page)).toEqual([]);
});
