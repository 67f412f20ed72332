import { compareImages } from '../support/images';
import { expect, test } from '../support/test';
import { openViewer, readImage, still } from '../support/viewer';

test('the same time gives the same pixels in another load of the page, another time and another seed others @verify', async ({
  page,
}) => {
  await openViewer(page, { ...still, scene: 'temple', time: 2.5 });
  const first = await readImage(page);
  await openViewer(page, { ...still, scene: 'temple', time: 0 });
  const other = await readImage(page);
  // Arrived at by another way: through other times, forth and back.
  await page.evaluate(() => {
    for (const seconds of [7, 0.1, 2.5]) window.viewer.renderAt(seconds);
  });
  const again = await readImage(page);

  expect(compareImages(first, again)).toEqual({ largest: 0, psnr: Infinity, share: 0, alpha: 0 });
  expect(compareImages(first, other).largest).toBeGreaterThan(0.01);
  await openViewer(page, { ...still, scene: 'temple', time: 2.5, seed: 2 });
  expect(compareImages(first, await readImage(page)).largest, 'another seed').toBeGreaterThan(0.01);
});
