import { figuresOf } from '../support/images';
import { expect, test } from '../support/benchTest';

/** Least that 'lite' is to 'full', after sRGB encoding, which weighs dark pixels more than linear values do (dB). */
const PSNR = 45;

const techniques = ['tiled-deferred', 'clustered-deferred', 'deferred'] as const;

for (const sheet of ['materials', 'maps', 'geometry', 'glTF'] as const) {
  test(`lite shows each case of the sheet ${sheet} as full does @verify`, async ({ benchPage: page }) => {
    test.setTimeout(240_000);
    const results = await page.evaluate((name) => window.testPage.compareQualities(name, 'tiled-deferred'), sheet);
    expect(results.length).toBeGreaterThan(5);
    // some are drawn by other formats, or the test tests nothing
    expect(results.some(({ largest }) => largest > 0)).toBe(true);
    const off = results.filter(({ psnr }) => psnr < PSNR).map((result) => `${result.case}: ${figuresOf(result)}`);
    expect(off).toEqual([]);
    const least = Math.min(...results.map(({ psnr }) => psnr));
    test.info().annotations.push({ type: 'lite', description: `${sheet}: least ${least.toFixed(1)} dB` });
  });
}

test('lite shows materials, and shadows of each kind of light, as full does, by techniques with a G-buffer', async ({
  benchPage: page,
}) => {
  test.setTimeout(240_000);
  const results = await page.evaluate(async (techniques) => {
    const { Bench, compareImages, farol, isSlice, materialScene, shadowScene, techniqueInTurn } = window.testPage;
    await farol.FarolRenderer.preload();
    const bench = new Bench(320, 180);
    bench.webgl.shadowMap.enabled = true;
    const scenes = {
      materials: materialScene(320, 180),
      shadows: shadowScene(320, 180, { caster: 'mixed', settings: { mapSize: 1024 }, few: isSlice }),
    };
    return Object.entries(scenes).flatMap(([name, { scene, camera }], turn) =>
      techniqueInTurn(turn, techniques).map((technique) => {
        bench.farol.quality = 'full';
        const full = bench.byTechnique(technique, scene, camera);
        const before = { ...bench.farol.info.memory, total: bench.farol.info.targetBytes };
        bench.farol.quality = 'lite';
        const lite = bench.byTechnique(technique, scene, camera);
        const after = { ...bench.farol.info.memory, total: bench.farol.info.targetBytes };
        return { ...compareImages(full, lite), name, technique, before, after };
      }),
    );
  }, techniques);
  for (const { name, technique, before, after, ...difference } of results) {
    const said = `${name}, ${technique}: ${figuresOf(difference)}`;
    test.info().annotations.push({ type: 'lite', description: said });
    expect.soft(difference.psnr, said).toBeGreaterThanOrEqual(PSNR);
    expect.soft([before.gbufferPixel, after.gbufferPixel], said).toEqual([20, 14]);
    expect.soft(after.total, said).toBeLessThan(before.total);
  }
});
