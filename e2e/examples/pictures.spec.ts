import { readdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { isWhole } from '@farol/tools/extent';
import { drawExample, openExample } from '../support/example';
import { compareImages, isFlat } from '../support/images';
import { expect, test } from '../support/test';

const folder = fileURLToPath(new URL('../pages/examples', import.meta.url));
const examples = readdirSync(folder, { withFileTypes: true })
  .filter((entry) => entry.isDirectory() && readdirSync(`${folder}/${entry.name}`).includes('index.html'))
  .map(({ name }) => name);

/** Examples that draw in more than one way, where both families are looked at; of the others the deferred one. */
const byBoth = ['composer', 'gltf', 'mixed'];
/** One technique of each family: the forward one agrees to a rounding of the canvas, the deferred one as in the README. */
const asked = { 'clustered-forward': { psnr: 60, share: 0 }, deferred: { psnr: 55, share: 0.001 } };

/** One of each way to draw in the slice; behaviour, attach and drei.spec.ts open the others. */
const inSlice = ['composer', 'postprocessing'];

for (const name of examples) {
  test(`${name}: the picture is that of three's own renderer${inSlice.includes(name) ? '' : ' @verify'}`, async ({
    page,
    watch,
  }) => {
    await openExample(page, name);
    const stock = await drawExample(page, 'three');
    expect(isFlat(stock)).toBe(false);
    for (const [technique, { psnr, share }] of Object.entries(asked)) {
      if (technique !== 'deferred' && !(isWhole && byBoth.includes(name))) continue;
      const found = compareImages(await drawExample(page, technique), stock);
      const { technique: drew, drawCalls } = await page.evaluate(() => window.example.farol.info);
      expect(drew).toBe(technique);
      expect(drawCalls).toBeGreaterThan(1);
      expect(found.psnr, `${technique}: PSNR (dB)`).toBeGreaterThanOrEqual(psnr);
      expect(found.share, `${technique}: share of pixels off by more than 2/255`).toBeLessThanOrEqual(share);
    }
    expect(compareImages(await drawExample(page, 'three'), stock).largest, 'stock three afterwards').toBe(0);
    if (/r3f|drei/.test(name)) watch.forgive(/THREE\.Clock: This module has been deprecated/); // React Three Fiber uses THREE.Clock
  });
}
