import { expect, test } from '../support/benchTest';
test('debug', async ({ benchPage: page }) => {
  const rows = await page.evaluate(async () => {
    const { Bench, pixelScenes } = window.testPage;
    const { explainPixel, pixelScenes: scenes } = await pixelScenes();
    const bench = new Bench(96, 64);
    const { scene, camera } = scenes.probes(bench);
    const { farol } = bench;
    const at = { x: (71.5 / 96) * 2 - 1, y: (11.5 / 64) * 2 - 1 };
    const out = [];
    const image = bench.byTechnique('forward-single-pass', scene, camera);
    out.push([...image.data.subarray((11 * 96 + 71) * 4, (11 * 96 + 71) * 4 + 3)]);
    const l = await explainPixel(farol, scene, camera, at);
    out.push(l.color.toArray(), l.sum.toArray(), l.lights.map((e) => [e.light.intensity, e.distance, ...e.color.toArray(), ...e.unshadowed.toArray()]));
    const dark = scene.children.find((c) => (c as any).intensity < 0)!;
    dark.visible = false;
    const without = bench.byTechnique('forward-single-pass', scene, camera);
    out.push([...without.data.subarray((11 * 96 + 71) * 4, (11 * 96 + 71) * 4 + 3)]);
    const stock = bench.stock(scene, camera);
    out.push([...stock.data.subarray((11 * 96 + 71) * 4, (11 * 96 + 71) * 4 + 3)]);
    return out;
  });
  for (const r of rows) console.log(JSON.stringify(r));
  expect(rows).toBeTruthy();
});
