import { compareImages, isFlat } from '../support/images';
import { hideFloatTargets } from '../support/hideFloatTargets';
import { expect, test } from '../support/test';
import { openViewer, readImage, still } from '../support/viewer';

test('on a device without float colour buffers the viewer draws, and says in one sentence by what', async ({
  page,
  watch,
}) => {
  await hideFloatTargets(page);
  await openViewer(page, { ...still, technique: 'deferred', aa: 'smaa', gui: 1 });
  expect(await page.evaluate(() => window.viewer.farol.technique)).toBe('auto');
  const message = page.getByText('draws to no float colour buffers');
  await expect(message).toContainText('Shown instead: auto.');
  const image = await readImage(page);
  expect(isFlat(image)).toBe(false);
  expect(compareImages(image, await readImage(page, 'three')).share).toBe(0);
  // from the menu it stays with what draws
  await page.getByLabel('Technique').selectOption('Forward+');
  await page.getByLabel('Technique').selectOption('Tiled deferred');
  await page.getByLabel('View').selectOption('Normal');
  await expect(message).toContainText('Shown instead: final.');
  expect(await page.evaluate(() => window.viewer.farol.technique)).toBe('forward-plus');
  expect(watch.forgive(/EXT_color_buffer_float extension not supported/), "three's own").toBe(1);
  expect(watch.forgive(/Farol: SMAA is left out, since this device draws to no float colour buffers/)).toBe(1);
});
