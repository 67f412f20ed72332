import { hideFloatTargets } from '../support/hideFloatTargets';
import { expect, test } from '../support/test';
import { addObject, openEditor } from './editor';

test.use({ viewport: { width: 840, height: 400 }, reducedMotion: 'reduce' });

test('on a device without float colour buffers the editor draws, and names what cannot be @verify', async ({
  page,
  watch,
}) => {
  await hideFloatTargets(page);
  await openEditor(page, 'empty');
  await addObject(page, 'Mesh', 'Sphere');
  await page.keyboard.press('f');
  const notices = page.getByText(/float colour buffers/);
  const close = () => page.getByRole('button', { name: 'Close message' }).click();
  await page.getByRole('tab', { name: 'Frame' }).click();
  const frame = page.getByRole('region', { name: 'Frame', exact: true });
  await frame.getByRole('combobox', { name: 'Technique of the frame' }).click();
  await page.getByRole('option', { name: /^Deferred shading/ }).click();
  await expect(notices).toHaveCount(1);
  await close();
  for (const name of ['Compare two techniques', 'All views at once']) {
    await frame.getByRole('checkbox', { name }).click();
    await expect(notices).toHaveCount(1);
    await close();
    await expect(frame.getByRole('checkbox', { name })).not.toBeChecked();
  }
  expect(await page.evaluate(() => window.editor.viewport.technique)).toBe('auto');
  // the small picture of a camera, and thumbnails
  const look = () =>
    page.evaluate(() => {
      const { viewport, document } = window.editor;
      const gl = viewport.webgl.getContext();
      const [width, height] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
      const read = () => {
        viewport.renderNow();
        const pixels = new Uint8Array(width * height * 4);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
        return pixels;
      };
      document.selection.set([]);
      const without = read();
      document.selection.set([document.scene.componentsOf('Camera')[0].gameObject.id]);
      const preview = read();
      const x = width - 60;
      const seen = new Set<string>();
      for (let y = 20; y < 120; y++) seen.add(preview.slice((y * width + x) * 4, (y * width + x) * 4 + 3).join());
      return { seen: seen.size, same: without.join() === preview.join(), error: gl.getError() };
    });
  // the small picture's code comes after the first frame
  let colours = await look();
  await expect.poll(async () => (colours = await look()).same).toBe(false);
  expect(colours.error).toBe(0);
  expect(colours.seen, 'colours of the small picture').toBeGreaterThan(1);
  await page.getByRole('tab', { name: 'Assets' }).click();
  await expect(page.locator('[data-asset]').first()).toBeVisible();
  expect(watch.forgive(/EXT_color_buffer_float extension not supported/), "three's own").toBe(1);
});
