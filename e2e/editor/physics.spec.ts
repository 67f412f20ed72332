import { byExtent } from '@farol/tools/extent';
import type { Page } from '@playwright/test';
import { addObject, fieldOf, history, menuIsGone, serialized } from './editor';
import { expect, test } from './sharedEditor';

test.use({ viewport: { width: 1200, height: 700 } });

/** By the bar of menus. */
async function makePhysics(page: Page, label: string): Promise<void> {
  await page.getByRole('menuitem', { name: 'Object', exact: true }).click();
  await page.getByRole('menuitem', { name: 'Physics', exact: true }).press('ArrowRight');
  await page.getByRole('menuitem', { name: label, exact: true }).click();
  await menuIsGone(page);
}

/** Bits of where the box is. */
const placeOf = (page: Page): Promise<number[]> =>
  page.evaluate(() => {
    const { position, quaternion } = window.editor.document.scene.find('Box')!.object3D;
    return [...position.toArray(), ...quaternion.toArray()];
  });

/** Number of pixels in the green of colliders. */
const greenPixels = (page: Page): Promise<number> =>
  page.evaluate(() => {
    const { viewport } = window.editor;
    viewport.renderNow();
    const { canvas } = viewport;
    const copy = document.createElement('canvas');
    [copy.width, copy.height] = [canvas.width, canvas.height];
    const context = copy.getContext('2d')!;
    context.drawImage(canvas, 0, 0);
    const { data } = context.getImageData(0, 0, copy.width, copy.height);
    let count = 0;
    for (let i = 0; i < data.length; i += 4) {
      // the handles' green is yellower
      if (data[i + 1] > data[i] + 40 && data[i + 2] > data[i] + 15 && data[i + 1] > data[i + 2] + 25) count++;
    }
    return count;
  });

test('a box with a body falls on a plane and is put back; its collider is seen, and sized by its handles', async ({
  page,
}) => {
  await addObject(page, 'Mesh', 'Plane');
  const plane = page.getByRole('region', { name: 'Transform', exact: true });
  await plane.getByLabel('Position y').fill('0');
  await page.keyboard.press('Enter');
  expect(await greenPixels(page)).toBe(0);
  await makePhysics(page, 'Add fixed collider');
  await expect.poll(async () => (await history(page)).at(-1)).toBe('Added physics to Plane');
  expect(await fieldOf(page, 'Plane', 'Collider', 'shape')).toBe('box');
  await addObject(page, 'Mesh', 'Box');
  await page.getByRole('region', { name: 'Transform', exact: true }).getByLabel('Position y').fill('1.5');
  await page.keyboard.press('Enter');
  await makePhysics(page, 'Add dynamic body and collider');
  await expect.poll(async () => (await history(page)).at(-1)).toBe('Added physics to Box');
  // half of the pixels that the box's collider has: 49 in the slice, whose picture has a quarter of the pixels, 376 in verify
  const some = byExtent({ slice: 25, verify: 200 });
  await expect.poll(() => greenPixels(page)).toBeGreaterThan(some);
  const selected = await greenPixels(page);
  await page.getByRole('button', { name: /^Colliders and joints of all objects/ }).click();
  await expect.poll(() => greenPixels(page)).toBeGreaterThan(selected + some);

  const before = await serialized(page);
  const place = await placeOf(page);
  await page.keyboard.press('Control+p');
  await expect.poll(async () => (await placeOf(page))[1]).toBeLessThan(0.6);
  await expect.poll(async () => Math.abs((await placeOf(page))[1] - 0.5)).toBeLessThan(0.01);
  await page.keyboard.press('Control+Alt+p');
  await page.getByRole('button', { name: /^Stop/ }).click();
  expect(await placeOf(page)).toEqual(place);
  expect(await serialized(page)).toBe(before);

  // the handle on the side of the box to +X of the world
  const handle = await page.evaluate(() => {
    const { viewport, document } = window.editor;
    viewport.renderNow();
    const { left, top, width, height } = viewport.panes.active.bounds;
    const box = document.scene.find('Box')!.object3D;
    const toPage = (x: number): { x: number; y: number } => {
      const seen = box.position
        .clone()
        .setX(box.position.x + x)
        .project(viewport.camera as never);
      return { x: left + ((seen.x + 1) / 2) * width, y: top + ((1 - seen.y) / 2) * height };
    };
    return { from: toPage(0.5), to: toPage(1.5) };
  });
  const steps = (await history(page)).length;
  await page.mouse.move(handle.from.x, handle.from.y);
  await page.mouse.down();
  await page.mouse.move(handle.to.x, handle.to.y, { steps: 4 });
  await page.mouse.up();
  expect((await history(page)).slice(steps)).toEqual(['Sized the collider of Box']);
  const [width, height] = (await fieldOf(page, 'Box', 'Collider', 'size')) as number[];
  expect(width).toBeCloseTo(2, 1);
  expect(height).toBe(1);
  const [offset] = (await fieldOf(page, 'Box', 'Collider', 'offset')) as number[];
  expect(offset).toBeCloseTo(0.5, 1);
  await page.keyboard.press('Control+z');
  expect(await serialized(page)).toBe(before);
});
