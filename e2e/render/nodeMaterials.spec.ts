import { checkAgreement } from '../support/agreement';
import { expect, test } from '../support/test';

test('node materials (TSL) are drawn as stock three draws them, by each technique, in depth among the rest', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(async () => {
    const { Bench, compareImages, effects, farol, nodeScene } = window.testPage;
    const bench = new Bench(96, 64);
    const { scene, camera, sun } = (await nodeScene()).nodeScene(bench.webgl, 96, 64);
    const names = (Object.keys(farol.techniques) as (keyof typeof farol.techniques)[]).filter(
      (name) => name !== 'auto',
    );
    const { webgl } = bench;
    // attributes of its nodes are there from the second frame on
    bench.stock(scene, camera);
    await Promise.resolve();
    const stock = bench.stock(scene, camera);
    const results = [];
    for (const name of names) {
      bench.byTechnique(name, scene, camera);
      await Promise.resolve();
      results.push({ name, difference: compareImages(stock, bench.byTechnique(name, scene, camera)) });
    }
    const again = compareImages(stock, bench.stock(scene, camera)).largest;
    // with shadows, which three draws for them
    webgl.shadowMap.enabled = sun.castShadow = true;
    scene.traverse((object) => {
      if ('isMesh' in object) object.castShadow = object.receiveShadow = true;
    });
    const shadowed = bench.stock(scene, camera);
    for (const name of ['forward-plus', 'deferred'] as const) {
      results.push({ name, difference: compareImages(shadowed, bench.byTechnique(name, scene, camera)) });
    }
    bench.farol.effects = [
      new effects.WeightedBlendedOIT(),
      new effects.AmbientOcclusion(),
      new effects.MultisampledEdges(),
    ];
    bench.byTechnique('deferred', scene, camera);
    bench.farol.effects = [];
    for (const view of farol.views) {
      bench.farol.view = view;
      bench.byTechnique('forward', scene, camera);
    }
    return { results, again };
  });
  for (const { name, difference } of results.results) checkAgreement(name, difference, 'node materials');
  expect(results.again, 'stock three afterwards').toBe(0);
});

test('until the code of node materials is there three draws the scene, then Farol does: the same picture', async ({
  page,
  pagesURL,
}) => {
  await page.goto(`${pagesURL}?lazy`);
  await page.waitForFunction(() => 'testPage' in window);
  const results = await page.evaluate(async () => {
    const { Bench, compareImages, farol, nodeScene } = window.testPage;
    const bench = new Bench(64, 48);
    const { scene, camera } = (await nodeScene()).nodeScene(bench.webgl, 64, 48);
    bench.stock(scene, camera);
    await Promise.resolve();
    const stock = bench.stock(scene, camera);
    const before = compareImages(stock, bench.byTechnique('clustered-forward', scene, camera));
    await farol.FarolRenderer.preload();
    bench.byTechnique('clustered-forward', scene, camera);
    await Promise.resolve();
    return { before, after: compareImages(stock, bench.byTechnique('clustered-forward', scene, camera)) };
  });
  expect(results.before.largest, 'by three').toBe(0);
  checkAgreement('clustered-forward', results.after, 'node materials, once their code is there');
});
