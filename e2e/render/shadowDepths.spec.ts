import { expectAsMeasured } from '../support/agreement';
import { expect, test } from '../support/benchTest';

const kinds = { basic: 0, pcf: 1, vsm: 3 } as const;
const depths = {
  normal: {},
  logarithmic: { logarithmicDepthBuffer: true },
  reversed: { reversedDepthBuffer: true },
} as const;

/**
 * Shadows of one kind, by one kind of depth buffer, under one kind of light: measured by forward-single-pass and by deferred
 * (dB). three has no variance shadow maps of point lights. A spot light that casts shadows lights nothing where depth is
 * logarithmic, in three as in Farol, so that no shadow is seen.
 */
const table: readonly [
  kind: keyof typeof kinds,
  depth: keyof typeof depths,
  caster: 'spot' | 'directional' | 'point',
  measured: readonly [number, number],
  inSlice?: boolean,
][] = [
  ['basic', 'normal', 'spot', [60, 46]],
  ['basic', 'normal', 'directional', [54, 46]],
  ['basic', 'normal', 'point', [52, 41.4]],
  ['basic', 'logarithmic', 'spot', [60, 46]],
  ['basic', 'logarithmic', 'directional', [54, 46]],
  ['basic', 'logarithmic', 'point', [52, 41.4]],
  ['basic', 'reversed', 'spot', [60, 46]],
  ['basic', 'reversed', 'directional', [54, 46]],
  ['basic', 'reversed', 'point', [52, 41.4]],
  ['pcf', 'normal', 'spot', [70, 64]],
  ['pcf', 'normal', 'directional', [64, 60]],
  ['pcf', 'normal', 'point', [58, 56]],
  ['pcf', 'logarithmic', 'spot', [90, 60]],
  ['pcf', 'logarithmic', 'directional', [64, 60]],
  ['pcf', 'logarithmic', 'point', [58, 56]],
  ['pcf', 'reversed', 'spot', [70, 64]],
  ['pcf', 'reversed', 'directional', [64, 60]],
  ['pcf', 'reversed', 'point', [58, 56], true],
  ['vsm', 'normal', 'spot', [69, 62]],
  ['vsm', 'normal', 'directional', [90, 63]],
  ['vsm', 'logarithmic', 'spot', [90, 60]],
  ['vsm', 'logarithmic', 'directional', [90, 63]],
  ['vsm', 'reversed', 'spot', [69, 63]],
  ['vsm', 'reversed', 'directional', [90, 63]],
];

for (const [kind, depth, caster, measured, inSlice] of table) {
  const title = `${kind} shadows of ${caster} lights, ${depth} depth: as in stock three`;
  test(inSlice ? title : `${title} @verify`, async ({ benchPage: page }) => {
    const seen = await page.evaluate(
      ([type, renderer, caster]) => {
        const { Bench, compareImages, shadowScene } = window.testPage;
        const bench = new Bench(96, 72, { renderer });
        bench.webgl.shadowMap.enabled = true;
        bench.webgl.shadowMap.type = type;
        const { scene, camera, lights } = shadowScene(96, 72, { caster });
        // Farol comes first: three's first frame brings the cameras of shadows up to date
        const images = (['forward-single-pass', 'deferred'] as const).map((technique) =>
          bench.byTechnique(technique, scene, camera),
        );
        const stock = bench.stock(scene, camera);
        const { reversedDepthBuffer, logarithmicDepthBuffer } = bench.webgl.capabilities;
        for (const light of lights) light.castShadow = false;
        return {
          depth: reversedDepthBuffer ? 'reversed' : logarithmicDepthBuffer ? 'logarithmic' : 'normal',
          matters: compareImages(stock, bench.byTechnique('forward-single-pass', scene, camera)).psnr,
          psnr: images.map((image) => compareImages(stock, image).psnr),
        };
      },
      [kinds[kind], depths[depth], caster] as const,
    );
    expect(seen.depth).toBe(depth);
    expect(seen.matters, 'the shadows are to be seen').toBeLessThan(32);
    expectAsMeasured(seen.psnr[0], measured[0], 'forward-single-pass');
    expectAsMeasured(seen.psnr[1], measured[1], 'deferred');
  });
}

test('a spot light throws its map where depth is reversed, as in stock three @verify', async ({ benchPage: page }) => {
  const { reversed, psnr, matters } = await page.evaluate(() => {
    const { Bench, compareImages, shadowScene, three } = window.testPage;
    const bench = new Bench(64, 48, { renderer: { reversedDepthBuffer: true } });
    bench.webgl.shadowMap.enabled = true;
    const map = new three.DataTexture(new Uint8Array(4 * 4 * 4).fill(120), 4, 4);
    map.needsUpdate = true;
    const { scene, camera, lights } = shadowScene(64, 48, { caster: 'spot', map });
    const image = bench.byTechnique('forward-single-pass', scene, camera);
    const stock = bench.stock(scene, camera);
    (lights[0] as { map?: unknown }).map = null;
    const without = bench.byTechnique('forward-single-pass', scene, camera);
    return {
      reversed: bench.webgl.state.buffers.depth.getReversed(),
      psnr: compareImages(stock, image).psnr,
      matters: compareImages(stock, without).psnr,
    };
  });
  expect(reversed).toBe(true);
  expect(matters, 'the map is to be seen').toBeLessThan(32);
  expectAsMeasured(psnr, 63.8, 'reversed depth');
});
