import { expect, test } from '../support/test';
import { openEditor } from './editor';

test.use({ viewport: { width: 900, height: 560 }, reducedMotion: 'reduce' });

test('what is told of the picture goes when the picture is back: a lost device, a frame that failed @verify', async ({
  page,
  watch,
}) => {
  await openEditor(page, 'empty');
  const notices = page.locator('.notices');
  await page.evaluate(() => {
    const extension = window.editor.viewport.webgl.getContext().getExtension('WEBGL_lose_context')!;
    Reflect.set(window, 'restore', () => extension.restoreContext());
    extension.loseContext();
  });
  await expect(notices).toContainText('The graphics device was lost.');
  await page.evaluate(() => (Reflect.get(window, 'restore') as () => void)());
  await expect(notices).toHaveText('');
  expect(watch.forgive(/context was lost|Context Lost/i)).toBeGreaterThan(0);

  // a change of the selection asks for a frame
  const draw = (): Promise<void> =>
    page.evaluate(() => {
      const { selection, scene } = window.editor.document;
      selection.set(selection.ids.length > 0 ? [] : [scene.roots[0].id]);
    });
  await page.evaluate(() => {
    Object.assign(window.editor.viewport.farol, {
      render: () => {
        throw new Error('The lamp is broken.');
      },
    });
  });
  await draw();
  await expect(notices).toContainText('The picture cannot be drawn: The lamp is broken.');
  // two at a time, of which the picture at rest takes neither away by a frame of its own
  await page.evaluate(() => {
    const { viewport } = window.editor as unknown as { viewport: { onError(error: Error): void } };
    viewport.onError(new Error('The lens is broken.'));
    Reflect.deleteProperty(window.editor.viewport.farol, 'render');
  });
  await expect(notices).toContainText('The picture cannot be drawn: The lens is broken.');
  await draw();
  await expect(notices).toHaveText('');
  expect(watch.forgive(/The (lamp|lens) is broken/)).toBe(2);
});

test('without WebGL 2 editor and player say what to do', async ({ page, watch }, info) => {
  await page.addInitScript(() => {
    HTMLCanvasElement.prototype.getContext = () => null;
  });
  for (const address of ['./', './player.html#scene=x']) {
    await page.goto(address);
    const alert = page.getByRole('alert');
    await expect(alert, address).toContainText('hardware acceleration');
    await expect(alert).toContainText('WebGL 2');
    await expect(alert).toContainText('get.webgl.org');
    await page.setViewportSize({ width: 390, height: 600 });
    expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390);
    await page.screenshot({ path: info.outputPath('no-webgl2.png') });
    expect(watch.forgive(/WebGL/)).toBeGreaterThan(0);
  }
});
