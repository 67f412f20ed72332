import { basename, join } from 'node:path';
import type { Page } from '@playwright/test';
import type { Light } from '@farol/engine';
import { recordComparison } from '../support/comparison';
import { drop } from '../support/drop';
import { compareImages, figuresOf, isFlat } from '../support/images';
import { expect, test } from '../support/test';
import { openViewer, readImage } from '../support/viewer';
import { filesOf, modelFiles } from './modelFiles';

/**
 * glTF models of a folder, opened as a user opens them and drawn under eight lights of mixed kinds by stock three and by
 * each technique, in linear float. The figures asked are those of the matrix. By hand:
 *
 * `FAROL_MODELS=folder npx playwright test -c e2e/playwright.config.ts e2e/models --workers=1`
 *
 * prints a line for each model and technique.
 */
const FOLDER = process.env.FAROL_MODELS ?? '';
const FORWARD = new Set(['forward', 'forward-single-pass', 'tiled-forward', 'forward-plus', 'clustered-forward']);
/** PSNR (dB) at least and share of pixels at most, where those of the matrix are not asked. */
const figures: Record<string, readonly [number, number] | undefined> = {
  // light at a quarter of the pixels: as far as e2e/support/agreement.ts has it
  inferred: [34, 0.12],
  // two pixels
  forward: [55, 1e-4],
};

/** Makes of the eight point lights round the model three points, four spots and a sun; the sky's light stays. */
async function mixLights(page: Page): Promise<void> {
  await page.evaluate(() => {
    const lights = window.viewer.engineScene.componentsOf<Light>('Light');
    const ring = lights.filter((light) => light.type === 'point');
    const middle = { x: 0, y: 0, z: 0 };
    for (const { position } of ring) {
      middle.x += position.x / ring.length;
      middle.y += position.y / ring.length;
      middle.z += position.z / ring.length;
    }
    ring.forEach((light, i) => {
      if (i % 3 === 0) return;
      light.gameObject.transform.lookAt([middle.x, middle.y, middle.z]);
      if (i === 2) Object.assign(light, { type: 'directional', intensity: 0.8 });
      else Object.assign(light, { type: 'spot', cutoff: 0.6, penumbra: 0.4, intensity: light.intensity * 3 });
    });
    window.viewer.renderAt(0.5);
  });
}

test.describe.configure({ timeout: 240_000 });

for (const name of modelFiles(FOLDER)) {
  test(`${name}, by every technique`, async ({ page }) => {
    const opening = { scene: 'benchmarkLights', lights: 8, n: 1, m: 1 };
    await openViewer(page, { ...opening, time: 0.5, width: 200, height: 150, dpr: 1, gui: 0 });
    await drop(page, filesOf(join(FOLDER, name)));
    await expect.poll(() => page.evaluate(() => window.viewer.modelName), { timeout: 60_000 }).toBe(basename(name));
    await page
      .evaluate(() => window.viewer.engineScene.componentsOf<Light>('Light').length)
      .then((count) => expect(count).toBe(9));
    await mixLights(page);
    const stock = await readImage(page, 'three');
    expect(isFlat(stock), 'stock three shows nothing').toBe(false);
    for (const technique of await page.evaluate(() => [...window.viewer.known.techniques])) {
      await page.evaluate((technique) => window.viewer.setTechnique(technique), technique);
      const difference = compareImages(stock, await readImage(page));
      const { largest, psnr, share, alpha } = difference;
      const seen = `${name}, ${technique}: ${figuresOf(difference)}`;
      console.log(seen);
      const [least, most] = figures[technique] ?? [55, 0.001];
      // of two sides at exactly one depth, at the outline, multipass shows another than stock three: see the README
      const exact = FORWARD.has(technique) && (technique !== 'forward' || share === 0);
      const good = alpha <= 1e-4 && (exact ? largest <= 1e-4 : psnr >= least && share <= most);
      recordComparison({ suite: 'models', technique, name, good, ...difference });
      expect.soft(good, seen).toBe(true);
    }
  });
}
