import { expect, test } from '../support/test';
import { axeProblems } from '../support/axeProblems';
import { addObject, fieldOf, history, openEditor, serialized } from './editor';

test.use({ viewport: { width: 1100, height: 560 }, reducedMotion: 'reduce' });

test('a plugin brings a panel, a component with a field of its own, a technique and a command', async ({ page }) => {
  await openEditor(page, 'empty');
  await addObject(page, 'Light', 'Point light');
  await page.keyboard.press('Control+k');
  await page.getByRole('combobox', { name: 'Search commands' }).fill('lantern');
  await page.getByRole('option', { name: /example of a plugin/ }).click();

  // the panel and the command
  await page.getByRole('tab', { name: 'Lantern' }).click();
  const panel = page.getByRole('region', { name: 'Lantern' });
  await expect(panel).toContainText('No lamp flickers.');
  await page.keyboard.press('Control+Alt+l');
  await expect(panel).toContainText('Flickering: Point light');
  expect((await history(page)).at(-1)).toBe('Add Flicker');
  expect(await axeProblems(page)).toEqual([]);

  // the component, with its kind of field, in the inspector and in the file
  await page.getByRole('tab', { name: 'Inspector' }).click();
  const flicker = page.getByRole('region', { name: 'Flicker', exact: true });
  await flicker.getByRole('slider', { name: 'Depth' }).focus();
  await page.keyboard.press('End');
  await page.keyboard.press('ArrowLeft');
  expect(await fieldOf(page, 'Point light', 'Flicker', 'depth')).toBe(0.99);
  const saved = await serialized(page);
  expect(saved).toContain('"depth": 0.99');
  await page.keyboard.press('Control+z');
  expect(await fieldOf(page, 'Point light', 'Flicker', 'depth')).toBe(1);
  expect(await axeProblems(page)).toEqual([]);

  // the technique draws
  await page.keyboard.press('Control+k');
  await page.getByRole('combobox', { name: 'Search commands' }).fill('vignette');
  await page.keyboard.press('Enter');
  await expect(page.getByRole('combobox', { name: 'Technique', exact: true })).toHaveText('Vignette');
  const [corner, middle] = await page.evaluate(() => {
    const { viewport } = window.editor;
    Object.assign(viewport, { showGrid: false, showIcons: false });
    window.editor.document.selection.set([]);
    const gl = viewport.webgl.getContext() as WebGL2RenderingContext;
    viewport.renderNow();
    const at = (x: number, y: number): number => {
      const pixel = new Uint8Array(4);
      gl.readPixels(x, y, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
      return pixel[0] + pixel[1] + pixel[2];
    };
    return [at(1, 1), at(gl.drawingBufferWidth >> 1, gl.drawingBufferHeight >> 1)];
  });
  expect(corner).toBeLessThan(middle * 0.6);

  // it is there again after a reload, before the scene that needs it
  await expect.poll(() => page.evaluate(() => window.editor.autosave?.isUpToDate)).toBe(true);
  await page.reload();
  await page.getByRole('button', { name: 'Recover' }).click();
  await page.getByRole('tab', { name: 'Lantern' }).click();
  await expect(panel).toContainText('Flickering: Point light');
  const known = await page.evaluate(() => Object.keys(window.editor.viewport.farol.techniques));
  expect(known).toContain('vignette');
});

test('a plugin whose names are taken is refused as a whole', async ({ page }) => {
  await openEditor(page, 'empty');
  const message = await page.evaluate(() => {
    try {
      window.editor.addPlugin({
        name: 'Clash',
        actions: [
          { id: 'clash.new', label: 'New', run() {} },
          { id: 'edit.undo', label: 'Undo', run() {} },
        ],
      });
      return '';
    } catch (error) {
      return (error as Error).message;
    }
  });
  expect(message).toContain("the action 'edit.undo'");
  await page.keyboard.press('Control+k');
  await page.getByRole('combobox', { name: 'Search commands' }).fill('clash');
  await expect(page.getByText('Nothing of that name.')).toBeVisible();
});
