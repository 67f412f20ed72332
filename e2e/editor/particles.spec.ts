import type { Page } from '@playwright/test';
import { addObject, fieldOf, history, serialized } from './editor';
import { expect, test } from './sharedEditor';

// a preview does not play where less motion is asked for
test.use({ viewport: { width: 900, height: 460 }, reducedMotion: 'no-preference' });

/** The picture as text. */
const picture = (page: Page): Promise<string> =>
  page.evaluate(() => {
    const { viewport } = window.editor;
    viewport.renderNow();
    return viewport.canvas.toDataURL();
  });

/** Time of the emitter (s). */
const emitterTime = (page: Page): Promise<number> =>
  page.evaluate(() => {
    const { three } = window.editor.document.scene.componentsOf('ParticleEmitter')[0] as unknown as {
      three: { time: number };
    };
    return three.time;
  });

test('a fire burns while it is selected; its curves are edited by pointer and keys; play begins anew, and stop restores', async ({
  page,
}) => {
  const empty = await picture(page);
  await addObject(page, 'Particles', 'Fire');
  const added = await serialized(page);
  const box = page.getByRole('region', { name: 'Preview of particles' });
  await expect(box).toContainText(/up to [1-9]\d+ particles/);
  await expect.poll(() => emitterTime(page)).toBeGreaterThan(0.2);
  await box.getByRole('button', { name: 'Pause the preview' }).click();
  const [first, at] = [await picture(page), await emitterTime(page)];
  expect(first).not.toBe(empty);
  expect(await picture(page)).toBe(first);
  await box.getByRole('button', { name: 'Play the preview' }).click();
  await expect.poll(() => emitterTime(page)).toBeGreaterThan(at + 0.1);
  await box.getByRole('button', { name: 'Pause the preview' }).click();
  expect(await picture(page)).not.toBe(first);
  expect(await serialized(page)).toBe(added);

  await page.getByRole('button', { name: 'Size over life', exact: true }).click();
  const key = page.getByRole('slider', { name: 'Key 2 of 3' });
  const { x, y, width } = (await key.boundingBox())!;
  await page.mouse.move(x + width / 2, y + width / 2);
  await page.mouse.down();
  await page.mouse.move(x + 20, y + 30);
  await page.mouse.move(x + 40, y + 60);
  await page.mouse.up();
  const curve = (await fieldOf(page, 'Fire', 'ParticleEmitter', 'sizeOverLife')) as unknown as [number, number][];
  expect(curve).toHaveLength(3);
  expect(curve[1][0]).toBeGreaterThan(0.3);
  expect(curve[1][1]).toBeLessThan(0.7);
  expect((await history(page)).slice(-2)).toEqual(['Added Fire', 'Set size over life of Fire']);
  await page.keyboard.press('Escape');

  await page.getByRole('button', { name: 'Colour over life', exact: true }).click();
  const stop = page.getByRole('slider', { name: 'Colour 3 of' });
  await stop.press('Shift+ArrowRight');
  await expect(stop).toBeFocused();
  const count = await page.getByRole('slider', { name: /^Colour/ }).count();
  await page.keyboard.press('Delete');
  await expect(page.getByRole('slider', { name: /^Colour/ })).toHaveCount(count - 1);
  expect((await history(page)).slice(-3)).toEqual([
    'Set size over life of Fire',
    'Set colour over life of Fire',
    'Set colour over life of Fire',
  ]);
  await page.keyboard.press('Escape');
  for (let i = 0; i < 3; i++) await page.keyboard.press('Control+z');
  expect(await serialized(page)).toBe(added);

  await page.keyboard.press('Control+p');
  await expect.poll(() => emitterTime(page)).toBeGreaterThan(0.1);
  await expect(box).toHaveCount(0);
  await page.getByRole('button', { name: /^Stop/ }).click();
  expect(await emitterTime(page)).toBeCloseTo(0, 6);
  expect(await serialized(page)).toBe(added);

  // an emitter that goes takes its box with it, and nothing else
  await page.getByRole('treeitem', { name: 'Fire' }).click();
  await expect(box).toHaveCount(1);
  await page.keyboard.press('Delete');
  await expect(box).toHaveCount(0);
  await expect(page.getByRole('treeitem', { name: 'Camera' })).toBeVisible();
});
