import { drawExample, openExample } from '../support/example';
import { compareImages, isFlat } from '../support/images';
import { expect, test } from '../support/test';

/** One technique of each family: forward ones agree to a rounding of the canvas, the others as in the README. */
const asked = {
  'clustered-forward': { psnr: 60, share: 0 },
  forward: { psnr: 60, share: 0 },
  deferred: { psnr: 55, share: 0.001 },
};

const warningsOfOthers = /THREE\.Clock: This module has been deprecated|PCFSoftShadowMap has been deprecated/;

test('drei: what draws by itself has the picture of three', async ({ page, watch }) => {
  await openExample(page, 'drei');
  for (const part of await page.evaluate(() => window.example.parts!)) {
    await test.step(part, async () => {
      await page.evaluate((part) => window.example.show!(part), part);
      const stock = await drawExample(page, 'three');
      expect(isFlat(stock)).toBe(false);
      for (const [technique, { psnr, share }] of Object.entries(asked)) {
        const found = compareImages(await drawExample(page, technique), stock);
        expect.soft(found.psnr, `${part}, ${technique}: PSNR (dB)`).toBeGreaterThanOrEqual(psnr);
        expect.soft(found.share, `${part}, ${technique}: share off by more than 2/255`).toBeLessThanOrEqual(share);
      }
      expect.soft(compareImages(await drawExample(page, 'three'), stock).largest, `${part}, three again`).toBe(0);
    });
  }
  watch.forgive(warningsOfOthers);
});
