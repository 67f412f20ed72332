import type { Page } from '@playwright/test';
import { test as own } from '../support/test';
import { addObject, fieldOf, history, openEditor } from './editor';
import { expect, test } from './sharedEditor';

const options = { viewport: { width: 900, height: 640 }, reducedMotion: 'reduce' } as const;
test.use(options);
own.use(options);

/** Presses a key of the number pad, which Playwright has without NumLock only. */
const pressPad = (page: Page, digit: number): Promise<boolean> =>
  page.evaluate((key) => {
    const press = { key, code: `Numpad${key}`, bubbles: true, cancelable: true };
    return window.editor.viewport.canvas.dispatchEvent(new KeyboardEvent('keydown', press));
  }, String(digit));

/** Page position of an object's middle, or of a point `x` m beside it, in a view; the active view when none is named. */
const pointIn = (page: Page, object: string, pane?: string, x = 0): Promise<{ x: number; y: number }> =>
  page.evaluate(
    ([name, wanted, beside]) => {
      const { viewport, document } = window.editor;
      viewport.renderNow();
      const { object3D } = document.scene.find(name)!;
      const view = viewport.panes.list.find((each) => each.name === wanted) ?? viewport.panes.active;
      const place = object3D.getWorldPosition(object3D.position.clone());
      place.x += beside;
      place.project(view.editorCamera.camera);
      const { left, top, width, height } = view.bounds;
      return { x: left + ((place.x + 1) / 2) * width, y: top + ((1 - place.y) / 2) * height };
    },
    [object, pane, x] as const,
  );

const selected = (page: Page): Promise<string[]> =>
  page.evaluate(() => window.editor.document.selectedObjects.map(({ name }) => name));

test('views without perspective, kept views, and a camera that is flown', async ({ page }) => {
  await addObject(page, 'Mesh', 'Box');
  await page.evaluate(() => window.editor.document.scene.find('Box')!.transform.set('position', [0, 0.5, 0]));
  await pressPad(page, 1);
  await expect.poll(() => page.evaluate(() => window.editor.viewport.editorCamera.orthographic)).toBe(true);

  // a click and a drag of a handle, without perspective
  await page.evaluate(() => window.editor.document.selection.set([]));
  const box = await pointIn(page, 'Box');
  await page.mouse.click(box.x, box.y);
  expect(await selected(page)).toEqual(['Box']);
  await page.waitForFunction(() => window.editor.viewport.gizmo.three.children.length > 1);
  const [handle, metre] = [await pointIn(page, 'Box', undefined, 0.7), await pointIn(page, 'Box', undefined, 1)];
  await page.mouse.move(handle.x, handle.y);
  await page.waitForFunction(() => window.editor.viewport.gizmo.isHot);
  await page.mouse.down();
  await page.mouse.move(handle.x + 2 * (metre.x - box.x), handle.y, { steps: 4 });
  await page.mouse.up();
  const [x, y, z] = (await fieldOf(page, 'Box', 'Transform', 'position')) as number[];
  expect(Math.abs(x - 2), `moved to ${x}`).toBeLessThan(0.02);
  expect([y, z]).toEqual([0.5, 0]);

  // turning the picture brings perspective back; a kept view is as it was
  await page.keyboard.press('Control+3');
  await page.mouse.move(450, 400);
  await page.mouse.down();
  await page.mouse.move(500, 420, { steps: 2 });
  await page.mouse.up();
  await expect.poll(() => page.evaluate(() => window.editor.viewport.editorCamera.orthographic)).toBe(false);
  await page.keyboard.press('3');
  const pose = await page.evaluate(() => window.editor.viewport.editorCamera.pose);
  expect(await page.evaluate(() => window.editor.document.scene.views.get(3))).toEqual({ name: '', ...pose });
  expect(pose.orthographic).toBe(true);

  // a camera that is looked through is flown: a drag is one step
  const steps = (await history(page)).length;
  const before = await fieldOf(page, 'Camera', 'Transform', 'rotation');
  await pressPad(page, 0);
  await expect(page.getByText('You fly Camera')).toBeVisible();
  await page.evaluate(() => window.editor.viewport.picture.ready);
  await page.mouse.move(450, 400);
  await page.mouse.down();
  await page.mouse.move(470, 404, { steps: 3 });
  await page.mouse.move(540, 410, { steps: 3 });
  await page.mouse.up();
  await expect.poll(async () => (await history(page)).slice(steps)).toEqual(['Fly Camera']);
  expect(await fieldOf(page, 'Camera', 'Transform', 'rotation')).not.toEqual(before);
  await page.keyboard.press('Control+z');
  expect(await fieldOf(page, 'Camera', 'Transform', 'rotation')).toEqual(before);
  await page.evaluate(() => (window.editor.document.scene.find('Camera')!.locked = true));
  await expect(page.getByText('Camera is locked: unlock it to move it.')).toBeVisible();
});

test('four views draw four pictures, each is worked in; keys go to the scene that plays', async ({ page }) => {
  await addObject(page, 'Mesh', 'Cone');
  await page.keyboard.press('Control+Alt+q');
  await expect.poll(() => page.evaluate(() => window.editor.viewport.panes.list.length)).toBe(4);
  await page.evaluate(() => window.editor.document.selection.set([]));
  await page.waitForFunction(() => {
    const { viewport } = window.editor;
    const gl = viewport.webgl.getContext() as WebGL2RenderingContext;
    viewport.renderNow();
    const ratio = viewport.webgl.getPixelRatio();
    const pictures = viewport.panes.list.map(({ rectangle }) => {
      const [width, height] = [rectangle.width * ratio, rectangle.height * ratio].map(Math.floor);
      const pixels = new Uint8Array(width * height * 4);
      const bottom = gl.drawingBufferHeight - (rectangle.y + rectangle.height) * ratio;
      gl.readPixels(rectangle.x * ratio, bottom, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
      return pixels;
    });
    const differs = (a: Uint8Array, b: Uint8Array): boolean => a.filter((value, i) => value !== b[i]).length > 300;
    // not before what draws the side views has come
    return pictures.every((a, i) => pictures.slice(i + 1).every((b) => differs(a, b)));
  });
  for (const pane of ['top', 'main', 'front', 'right']) {
    await page.evaluate(() => window.editor.document.selection.set([]));
    const { x, y } = await pointIn(page, 'Cone', pane);
    await page.mouse.click(x, y);
    expect(await selected(page), pane).toEqual(['Cone']);
    expect(await page.evaluate(() => window.editor.viewport.panes.active.name)).toBe(pane);
  }
  await page.keyboard.press('Control+Alt+q');

  await page.evaluate(() => {
    const camera = window.editor.document.scene.find('Camera')!;
    camera.addComponent('KeyController');
    window.editor.viewport.canvas.focus();
  });
  await page.keyboard.press('Alt+p');
  await expect(page.getByText('Keys go to the scene. Esc gives them back.')).toBeVisible();
  const place = (): Promise<number[]> =>
    page.evaluate(() => window.editor.document.scene.find('Camera')!.object3D.position.toArray());
  const from = await place();
  await page.keyboard.down('w');
  await page.keyboard.press('r');
  await expect.poll(place).not.toEqual(from);
  await page.keyboard.up('w');
  expect(await page.evaluate(() => window.editor.viewport.mode)).toBe('translate');
  await page.keyboard.press('Escape');
  await page.keyboard.press('r');
  expect(await page.evaluate(() => window.editor.viewport.mode)).toBe('scale');
  await page.keyboard.press('Control+p');
  expect(await place()).toEqual(from);
  expect(await page.evaluate(() => window.editor.viewport.lookThrough)).toBeNull();
});

own('the lines between four views are dragged, moved by keys, and remembered @verify', async ({ page }) => {
  await openEditor(page, 'empty');
  await page.keyboard.press('Control+Alt+q');
  const sizes = (): Promise<Record<string, [number, number]>> =>
    page.evaluate(() => {
      const list = window.editor.viewport.panes.list.map(({ name, rectangle: { width, height } }) => [
        name,
        [width, height],
      ]);
      return Object.fromEntries(list) as Record<string, [number, number]>;
    });
  const edge = page.getByRole('separator', { name: 'Edge between the views at the left and at the right' });
  await expect(edge).toHaveAttribute('aria-valuenow', '50');
  const before = await sizes();
  expect(before.top).toEqual(before.main);

  const corner = page.getByRole('separator', { name: 'Corner between the four views' });
  const box = (await corner.boundingBox())!;
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x - 60, y + 40, { steps: 3 });
  await page.mouse.up();
  await expect.poll(async () => Math.abs((await sizes()).top[0] - (before.top[0] - 60))).toBeLessThanOrEqual(2);
  const dragged = await sizes();
  expect(Math.abs(dragged.main[0] - (before.main[0] + 60))).toBeLessThanOrEqual(2);
  expect(Math.abs(dragged.front[1] - (before.front[1] - 40))).toBeLessThanOrEqual(2);
  expect(await page.evaluate(() => window.editor.document.selectedObjects.length)).toBe(0);

  const part = Number(await edge.getAttribute('aria-valuenow'));
  await edge.focus();
  await page.keyboard.press('ArrowRight');
  await expect(edge).toHaveAttribute('aria-valuenow', String(part + 2));
  await page.keyboard.press('ArrowUp');
  await expect(edge).toHaveAttribute('aria-valuenow', String(part + 2));
  const kept = await sizes();
  await page.reload();
  await page.evaluate(() => window.editor.ready);
  await expect.poll(sizes).toEqual(kept);
  await edge.dblclick();
  await expect(edge).toHaveAttribute('aria-valuenow', '50');
});
