import type { Page } from '@playwright/test';
import { addObject, fieldOf, history, serialized } from './editor';
import { expect, test } from './sharedEditor';

test.use({ viewport: { width: 1200, height: 700 } });

/** Page position (CSS pixels) of a point `x` and `y` (m) from the middle of an object, along its axes. */
const beside = (page: Page, object: string, x: number, y: number): Promise<{ x: number; y: number }> =>
  page.evaluate(
    ([name, x, y]) => {
      const { viewport, document } = window.editor;
      viewport.renderNow();
      const { object3D } = document.scene.find(name)!;
      const { left, top, width, height } = viewport.panes.active.bounds;
      const seen = object3D.localToWorld(object3D.position.clone().set(x, y, 0)).project(viewport.camera as never);
      return { x: left + ((seen.x + 1) / 2) * width, y: top + ((1 - seen.y) / 2) * height };
    },
    [object, x, y] as const,
  );

/** Adds a light, and looks at it from near by, so that its handles are clear of its icon. */
async function addLight(page: Page, name: string, handles: number): Promise<void> {
  await addObject(page, 'Light', name);
  await page.evaluate(() => window.editor.viewport.focus());
  const count = (): Promise<number | undefined> =>
    page.evaluate(() => {
      const { viewport } = window.editor;
      viewport.renderNow();
      return viewport.parts.lightHandles.part?.places.length;
    });
  await expect.poll(count).toBe(handles);
}

/** Drags from one place beside an object to another. @param readout - text beside the pointer at the end */
async function drag(
  page: Page,
  object: string,
  from: [number, number],
  to: [number, number],
  readout: RegExp,
): Promise<void> {
  const start = await beside(page, object, ...from);
  const end = await beside(page, object, ...to);
  await page.mouse.move(start.x, start.y);
  await page.mouse.down();
  await page.mouse.move(end.x, end.y, { steps: 4 });
  await expect(page.locator('.drag-readout')).toHaveText(readout);
  await page.mouse.up();
  await expect(page.locator('.drag-readout')).toHaveCount(0);
}

const sizeOf = (page: Page, object: string): Promise<unknown[]> =>
  Promise.all(['width', 'height'].map((field) => fieldOf(page, object, 'Light', field)));

test('lights with a shape are sized by their edges, one step a drag, with the value beside the pointer @verify', async ({
  page,
}) => {
  await addLight(page, 'Rectangle light', 4);
  const before = await serialized(page);
  const steps = (await history(page)).length;
  await drag(page, 'Rectangle light', [0.5, 0], [1, 0], /^Width (1\.9|2|2\.0)\d? m$/);
  expect((await history(page)).slice(steps)).toEqual(['Sized Rectangle light']);
  const [width, height] = await sizeOf(page, 'Rectangle light');
  expect(width).toBeCloseTo(2, 1);
  expect(height).toBe(1);
  await page.keyboard.press('Control+z');
  expect(await serialized(page)).toBe(before);

  // Escape takes a drag back
  const [from, to] = [await beside(page, 'Rectangle light', 0, 0.5), await beside(page, 'Rectangle light', 0, 0.8)];
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(to.x, to.y, { steps: 2 });
  await expect(page.locator('.drag-readout')).toHaveText(/^Height 1\.6\d? m$/);
  await page.keyboard.press('Escape');
  await page.mouse.up();
  expect(await serialized(page)).toBe(before);

  await addLight(page, 'Disc light', 4);
  await drag(page, 'Disc light', [0.5, 0], [0.75, 0], /^Radius 0\.7[45]\d? m$/);
  const [across, high] = await sizeOf(page, 'Disc light');
  expect(across).toBe(high);

  // from there its thickness is within its icon
  await addLight(page, 'Tube light', 2);
  await drag(page, 'Tube light', [0.6, 0], [1, 0], /^Length (1\.9|2|2\.0)\d? m$/);
});

test('the inspector shows the fields of shadows that a light with a shape has', async ({ page }) => {
  await addObject(page, 'Light', 'Rectangle light');
  const section = page.getByRole('region', { name: 'Light', exact: true });
  await section.getByLabel('Cast shadow').check();
  await expect(section.getByLabel('Shadow map size')).toBeVisible();
  await expect(section.getByLabel('Shadow normal bias')).toBeVisible();
  for (const name of ['Shadow softness', 'Shadow bias', 'Shadow extent'])
    await expect(section.getByLabel(name, { exact: true })).toHaveCount(0);
});
