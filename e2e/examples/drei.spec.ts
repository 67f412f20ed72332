import { byExtent } from '@farol/tools/extent';
import { drawExample, openExample } from '../support/example';
import { compareImages, isFlat } from '../support/images';
import { expect, test } from '../support/test';

/** One technique of each kind: forward ones agree to a rounding of the canvas, the others as in the README. */
const limits = {
  'clustered-forward': { psnr: 60, share: 0 },
  forward: { psnr: 60, share: 0 },
  deferred: { psnr: 55, share: 0.001 },
};
/** drei draws what is behind a portal with 8 samples a pixel, of which a G-buffer and the sums of `forward` have one. */
const multisampled = { ...limits, forward: { psnr: 45, share: 0.01 }, deferred: { psnr: 45, share: 0.01 } };

/** Warnings of other packages: R3F uses three's Clock. */
const forgiven = /THREE\.Clock: This module has been deprecated/;

/** In groups, which workers share among themselves. */
const groups = [
  ['View', 'Hud', 'GizmoHelper', 'EffectComposer', 'CubeCamera'],
  ['RenderTexture', 'MeshPortalMaterial', 'MeshPortalMaterial, half way in', 'Environment'],
  [
    'MeshReflectorMaterial',
    'ContactShadows',
    'AccumulativeShadows',
    'Farol in a View',
    'Farol in a RenderTexture',
    'FarolInComposer in an EffectComposer',
  ],
];

for (const [index, group] of groups.entries()) {
  test(`drei: ${group.join('; ')}: the picture of three${index === 0 ? '' : ' @verify'}`, async ({ page, watch }) => {
    await openExample(page, 'drei');
    const parts = await page.evaluate(() => window.example.parts!);
    expect([...parts].sort(), 'parts of the page').toEqual(groups.flat().sort());
    for (const part of byExtent({ slice: ['View'], verify: group })) {
      await page.evaluate((part) => window.example.show!(part), part);
      const stock = await drawExample(page, 'three');
      expect(isFlat(stock)).toBe(false);
      for (const [technique, limit] of Object.entries(part.startsWith('MeshPortal') ? multisampled : limits)) {
        const found = compareImages(await drawExample(page, technique), stock);
        expect(await page.evaluate(() => window.example.farol.info.drawCalls)).toBeGreaterThan(0);
        expect.soft(found.psnr, `${part}, ${technique}: PSNR (dB)`).toBeGreaterThanOrEqual(limit.psnr);
        expect
          .soft(found.share, `${part}, ${technique}: share off by more than 2/255`)
          .toBeLessThanOrEqual(limit.share);
      }
    }
    watch.forgive(forgiven);
  });
}
