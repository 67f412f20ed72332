import { expectAsMeasured } from '../support/agreement';
import { expect, test } from '../support/benchTest';

test('a spot light throws its map where depth is reversed, as in stock three', async ({ benchPage: page }) => {
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
