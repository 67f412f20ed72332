import type { Page } from '@playwright/test';
import type { LightMix, MaterialSceneOptions } from '../pages/materialScene';
import type { Difference } from '../support/images';
import { expect, test } from '../support/test';

/** How far a technique's picture may be from stock three's; what is left out is not asked. */
interface Limits {
  /** Largest linear difference of a channel, at most. */
  readonly largest?: number;
  /** Signal to noise, at least (dB). */
  readonly psnr?: number;
  /** Share of pixels off by more than 2/255, at most. */
  readonly share?: number;
  /** The same for lights with a hard edge. */
  readonly hardEdge: Omit<Limits, 'hardEdge'>;
}

/**
 * Every technique draws every lit material of three, on every kind of mesh, as stock three does, in linear float.
 *
 * Forward techniques run three's own shader: what is left is rounding. Techniques that keep the surface in a G-buffer
 * round albedo, roughness and metalness to 8 bits, normals to half floats, and add light in half floats; positions are
 * rebuilt, so that the pixels at a hard edge of light may fall on its other side. Inferred lighting computes light at a
 * quarter of the pixels: what changes from pixel to pixel (normal maps of noise, small highlights, edges of light) is
 * smoothed; measured 35.8 to 41.8 dB and 5 to 10% of pixels, 31 dB and 12% with hard edges.
 */
const FORWARD: Limits = { largest: 1e-4, hardEdge: { largest: 1e-4 } };
const DEFERRED: Limits = { psnr: 60, share: 0.001, hardEdge: { share: 0.001 } };
const limits: Record<string, Limits | undefined> = {
  forward: FORWARD,
  'forward-single-pass': FORWARD,
  inferred: { psnr: 35, share: 0.12, hardEdge: { psnr: 30, share: 0.14 } },
};
const WIDTH = 320;
const HEIGHT = 240;

interface Pair {
  technique: string;
  flat: boolean;
  difference: Difference;
}

/** Draws a scene by stock three once, and by each technique. */
async function drawAll(
  page: Page,
  options: Omit<MaterialSceneOptions, 'environment'>,
  environment: boolean,
): Promise<Pair[]> {
  return page.evaluate(
    ([width, height, options, environment]) => {
      const { Bench, compareImages, farol, isFlat, materialScene } = window.testPage;
      const bench = new Bench(width, height);
      const map = environment ? bench.environment() : null;
      const { scene, camera } = materialScene(width, height, { ...options, environment: map });
      const stock = bench.stock(scene, camera);
      return (Object.keys(farol.techniques) as (keyof typeof farol.techniques)[]).map((technique) => ({
        technique,
        flat: isFlat(stock),
        difference: compareImages(stock, bench.byTechnique(technique, scene, camera)),
      }));
    },
    [WIDTH, HEIGHT, options, environment] as const,
  );
}

function check({ technique, flat, difference }: Pair, name: string, hardEdge = false): void {
  expect(flat, `${name}: stock picture is flat`).toBe(false);
  const { largest, psnr, share } = difference;
  const seen = `${name}, ${technique}: largest ${largest.toExponential(2)}, ${psnr.toFixed(1)} dB, ${(share * 100).toFixed(3)}% off by more than 2/255`;
  test.info().annotations.push({ type: 'agreement', description: seen });
  const limit = limits[technique] ?? DEFERRED;
  const asked = hardEdge ? limit.hardEdge : limit;
  expect(largest, seen).toBeLessThanOrEqual(asked.largest ?? Infinity);
  expect(psnr, seen).toBeGreaterThanOrEqual(asked.psnr ?? 0);
  expect(share, seen).toBeLessThanOrEqual(asked.share ?? 1);
}

// Ten techniques on a software rasteriser that other tests share.
test.describe.configure({ timeout: 180_000 });

test.beforeEach(async ({ page, pagesURL }) => {
  await page.goto(pagesURL);
  await page.waitForFunction(() => 'testPage' in window);
});

test('all lit materials and meshes under 24 lights of mixed kinds, with an environment', async ({ page }) => {
  for (const pair of await drawAll(page, {}, true)) check(pair, 'mixed');
});

test('only what a G-buffer holds', async ({ page }) => {
  for (const pair of await drawAll(page, { onlyDeferred: true }, true)) check(pair, 'G-buffer materials');
});

test('an orthographic camera, and fog', async ({ page }) => {
  for (const pair of await drawAll(page, { orthographic: true }, false)) check(pair, 'orthographic');
  for (const pair of await drawAll(page, { fog: true }, false)) check(pair, 'fog');
});

const mixes: LightMix[] = ['point', 'spot', 'directional', 'hemisphere', 'unbounded'];
for (const mix of mixes) {
  test(`lights of one kind: ${mix}`, async ({ page }) => {
    for (const pair of await drawAll(page, { mix }, false)) check(pair, mix);
  });
}

test('spot lights with a hard edge: only the edge may differ where a position is rebuilt', async ({ page }) => {
  for (const pair of await drawAll(page, { mix: 'spot', penumbra: 0 }, false)) check(pair, 'hard edges', true);
});
