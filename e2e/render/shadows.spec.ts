import { expect, test } from '../support/test';

/**
 * Shadows against stock three, in linear float. Forward techniques run three's own filters: what differs are the seams of
 * point lights' cube maps, which three filters across its own faces and Farol across a border of one texel. Techniques with
 * a G-buffer rebuild positions, so that pixels at the edge of a texel may fall on its other side (`basic` has hard edges);
 * inferred lighting smooths what changes from pixel to pixel.
 */
const WIDTH = 128;
const HEIGHT = 96;

test.beforeEach(async ({ page, pagesURL }) => {
  await page.goto(pagesURL);
  await page.waitForFunction(() => 'testPage' in window);
});

const types = { basic: 0, pcf: 1 } as const;

for (const type of Object.keys(types) as (keyof typeof types)[]) {
  test(`${type} shadows of each kind of light: as in stock three`, async ({ page }) => {
    const seen = await page.evaluate(
      ([width, height, type]) => {
        const { Bench, compareImages, shadowScene } = window.testPage;
        const bench = new Bench(width, height);
        bench.webgl.shadowMap.enabled = true;
        bench.webgl.shadowMap.type = type;
        return (['spot', 'point', 'directional'] as const).map((caster) => {
          const { scene, camera, lights } = shadowScene(width, height, { caster });
          const stock = bench.stock(scene, camera);
          for (const light of lights) light.castShadow = false;
          const without = bench.byTechnique('forward-single-pass', scene, camera);
          for (const light of lights) light.castShadow = true;
          return {
            caster,
            matters: compareImages(stock, without).psnr,
            pairs: (['forward-single-pass', 'deferred'] as const).map((technique) => ({
              technique,
              ...compareImages(stock, bench.byTechnique(technique, scene, camera)),
            })),
          };
        });
      },
      [WIDTH, HEIGHT, types[type]] as const,
    );
    for (const { caster, matters, pairs } of seen) {
      expect(matters, `${caster}: the shadows are to be seen`).toBeLessThan(32);
      for (const { technique, psnr, share } of pairs) {
        const said = `${caster}, ${technique}: ${psnr.toFixed(1)} dB, ${(share * 100).toFixed(2)}% off by more than 2/255`;
        test.info().annotations.push({ type: 'agreement', description: said });
        expect(psnr, said).toBeGreaterThanOrEqual(45);
      }
    }
  });
}

test('shadows of all kinds of light at once, by every technique', async ({ page }) => {
  test.setTimeout(180_000);
  const pairs = await page.evaluate(
    ([width, height]) => {
      const { Bench, compareImages, farol, shadowScene } = window.testPage;
      const bench = new Bench(width, height);
      bench.webgl.shadowMap.enabled = true;
      const { scene, camera } = shadowScene(width, height, { caster: 'mixed' });
      const stock = bench.stock(scene, camera);
      return (Object.keys(farol.techniques) as (keyof typeof farol.techniques)[]).map((technique) => ({
        technique,
        ...compareImages(stock, bench.byTechnique(technique, scene, camera)),
      }));
    },
    [WIDTH, HEIGHT] as const,
  );
  for (const { technique, psnr, share } of pairs) {
    const said = `${technique}: ${psnr.toFixed(1)} dB, ${(share * 100).toFixed(2)}% off by more than 2/255`;
    test.info().annotations.push({ type: 'agreement', description: said });
    expect(psnr, said).toBeGreaterThanOrEqual(technique === 'inferred' ? 30 : 45);
  }
});
