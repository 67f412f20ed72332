import type { Page } from '@playwright/test';
import { drop } from '../support/drop';
import { expect, test } from '../support/test';
import { addObject, openEditor, pointOf } from './editor';

/**
 * Holds the code of parts of the editor back until each is let go of, then opens an empty scene.
 *
 * @param files - names without their endings, as patterns
 * @returns lets go of the code of each
 */
async function openWithout(page: Page, files: readonly string[]): Promise<(() => void)[]> {
  const letGo: (() => void)[] = [];
  for (const file of files) {
    const held = new Promise<void>((resolve) => letGo.push(resolve));
    await page.route(new RegExp(`/${file}[.-][\\w.-]+(\\?|$)`), async (route) => {
      await held;
      await route.continue();
    });
  }
  await openEditor(page, 'empty');
  return letGo;
}

/** Pixels of the picture that have about the orange of what is selected. */
const selectionPixels = (page: Page): Promise<number> =>
  page.evaluate(() => {
    const { viewport } = window.editor;
    const gl = viewport.webgl.getContext() as WebGL2RenderingContext;
    viewport.renderNow();
    const pixels = new Uint8Array(gl.drawingBufferWidth * gl.drawingBufferHeight * 4);
    gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    let count = 0;
    for (let i = 0; i < pixels.length; i += 4) {
      const [red, green, blue] = pixels.subarray(i, i + 3);
      if (red > 200 && green > 110 && green < 180 && blue < 110) count++;
    }
    return count;
  });

const selected = (page: Page): Promise<string[]> =>
  page.evaluate(() => window.editor.document.selectedObjects.map(({ name }) => name).toSorted());

// one page for all: what takes the time is to open it
test('outline, box selection, copies, groups, drops and flights wait for their code, and are there once it is', async ({
  page,
}) => {
  const files = ['SelectionLines', 'pickBox', '(clip|groupObjects)', '(CameraPreview|CameraFlight)', 'dropOn'];
  const [outline, box, copies, flight, dropped] = await openWithout(page, files);

  await test.step('the outline of what is selected', async () => {
    await addObject(page, 'Mesh', 'Box');
    expect(await selected(page)).toEqual(['Box']);
    expect(await selectionPixels(page)).toBe(0);
    outline();
    await expect.poll(() => selectionPixels(page)).toBeGreaterThan(30);
  });

  await test.step('a box that selects', async () => {
    await page.evaluate(() => window.editor.document.selection.set([]));
    await page.keyboard.press('q');
    const { x, y } = await pointOf(page, 'Box');
    await page.mouse.move(x - 40, y - 40);
    await page.mouse.down();
    await page.mouse.move(x + 40, y + 40, { steps: 3 });
    await page.mouse.up();
    await expect(page.locator('.select-box')).toBeHidden();
    expect(await selected(page)).toEqual([]);
    box();
    await expect.poll(() => selected(page)).toEqual(['Box']);
  });

  await test.step('copies and groups', async () => {
    await page.getByRole('treeitem', { name: 'Box' }).click();
    await page.keyboard.press('Control+c');
    await page.keyboard.press('Control+v');
    await expect(page.getByRole('treeitem', { name: 'Box 2' })).toHaveCount(0);
    copies();
    await expect(page.getByRole('treeitem', { name: 'Box 2' })).toBeVisible();
    await page.keyboard.press('Control+g');
    await expect(page.getByRole('treeitem', { name: 'Group' })).toBeVisible();
  });

  await test.step('a dropped file', async () => {
    const files = (): Promise<number> => page.evaluate(() => window.editor.document.scene.assets.files.length);
    const before = await files();
    await drop(page, { 'triangle.obj': 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' });
    expect(await files()).toBe(before);
    dropped();
    await expect.poll(files).toBeGreaterThan(before);
  });

  await test.step('a camera that is looked through stays where it is', async () => {
    await page.getByRole('treeitem', { name: 'Camera' }).click();
    await page.getByRole('button', { name: 'Look through Camera' }).click();
    const pose = (): Promise<readonly number[]> =>
      page.evaluate(() => [...window.editor.viewport.camera.matrixWorld.elements]);
    const before = await pose();
    await page.getByRole('img', { name: /Picture of the scene/ }).focus();
    await page.keyboard.press('ArrowLeft');
    expect(await pose()).toEqual(before);
    flight();
    await expect
      .poll(async () => {
        await page.keyboard.press('ArrowLeft');
        return (await pose()).some((value, i) => value !== before[i]);
      })
      .toBe(true);
  });
});
