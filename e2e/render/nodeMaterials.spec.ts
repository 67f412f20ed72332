import { checkAgreement } from '../support/agreement';
import { expect, test } from '../support/benchTest';
import { test as alone } from '../support/test';

test('node materials (TSL) are drawn as stock three draws them, by each technique, in depth among the rest', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(async () => {
    const { Bench, compareImages, drawn, effects, farol, nodeScene, techniquesInTurn } = window.testPage;
    const bench = new Bench(96, 64);
    const { scene, camera, sun } = (await nodeScene()).nodeScene(bench.webgl, 96, 64);
    const names = techniquesInTurn(3, drawn);
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
    // those after 'grid' show buffers of effects
    for (const view of farol.views.slice(0, farol.views.indexOf('grid') + 1)) {
      bench.farol.view = view;
      bench.byTechnique('forward', scene, camera);
    }
    return { results, again };
  });
  for (const { name, difference } of results.results) checkAgreement(name, difference, 'node materials');
  expect(results.again, 'stock three afterwards').toBe(0);
});

/** Techniques that draw each kind of node material. */
const TURNS = 2;

test('each kind of node material on each kind of object, under area lights and shadows, in fog, by techniques in turn @verify', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(async (turns) => {
    const { Bench, compareImages, drawn, isFlat, nodeCases } = window.testPage;
    const { nodeCase, nodeCases: cases, nodesHandler } = await nodeCases();
    const bench = new Bench(64, 48);
    const { webgl, farol } = bench;
    webgl.setNodesHandler(nodesHandler());
    webgl.shadowMap.enabled = webgl.localClippingEnabled = true;
    farol.inferredScale = 1;
    const results = [];
    for (const [i, [name, make]] of Object.entries(cases).entries()) {
      const { scene, camera } = nodeCase(make(), 64, 48);
      bench.stock(scene, camera);
      await Promise.resolve();
      const stock = bench.stock(scene, camera);
      for (let turn = 0; turn < turns; turn++) {
        const technique = drawn[(i * 2 + turn) % drawn.length];
        bench.byTechnique(technique, scene, camera);
        await Promise.resolve();
        const difference = compareImages(stock, bench.byTechnique(technique, scene, camera));
        results.push({ name, technique, difference, flat: isFlat(stock) });
      }
    }
    return results;
  }, TURNS);
  expect(results.length).toBeGreaterThan(30 * TURNS);
  for (const { name, technique, difference, flat } of results) {
    expect(flat, `${name}: stock picture is flat`).toBe(false);
    checkAgreement(technique, difference, `node material, ${name}`);
  }
});

// in a page of its own: what the device says of it comes late
alone(
  'glass of nodes is drawn as stock three draws it, which knows no transmission of nodes',
  async ({ benchPage: page, watch }) => {
    const results = await page.evaluate(async () => {
      const { alphaBench, compareImages, drawn, nodeCases, techniquesInTurn } = window.testPage;
      const { nodeCase, nodeGlass, nodesHandler } = await nodeCases();
      const { bench, toCanvas } = alphaBench(64, 48);
      bench.webgl.setNodesHandler(nodesHandler());
      bench.webgl.shadowMap.enabled = true;
      bench.farol.inferredScale = 1;
      const { scene, camera } = nodeCase(nodeGlass(), 64, 48);
      const draw = async (render: () => void) => {
        render();
        await Promise.resolve();
        return toCanvas(render);
      };
      const stock = await draw(() => bench.webgl.render(scene, camera));
      const results = [];
      for (const technique of techniquesInTurn(0, drawn)) {
        bench.farol.technique = technique;
        const difference = compareImages(stock, await draw(() => bench.farol.render(scene, camera)));
        results.push({ technique, difference });
      }
      return results;
    });
    // three's copy of what is behind, which it has no size of
    watch.forgive(/glTexStorage2D: One or more image dimensions are not positive/);
    for (const { technique, difference } of results) {
      expect.soft(difference.psnr, technique).toBeGreaterThan(60);
      expect.soft(difference.alpha, technique).toBe(0);
    }
  },
);

test('until the code of node materials is there three draws the scene, then Farol does: the same picture @verify', async ({
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

test('a frame leaves node materials as the host drew them, and both draw on as before @verify', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(async () => {
    const { alphaBench, compareImages, effects, hostSnapshot, nodeScene, three } = window.testPage;
    const { bench, toCanvas } = alphaBench(64, 48);
    const { scene, camera } = (await nodeScene()).nodeScene(bench.webgl, 64, 48);
    const { webgl, farol } = bench;
    webgl.toneMapping = three.ACESFilmicToneMapping;
    const byThree = () => toCanvas(() => webgl.render(scene, camera));
    const byFarol = () => toCanvas(() => farol.render(scene, camera));
    // attributes of its nodes are there from the second frame on
    byThree();
    await Promise.resolve();
    const stock = byThree();
    const results = [];
    for (const technique of ['forward-plus', 'deferred'] as const) {
      farol.technique = technique;
      farol.effects = technique === 'deferred' ? [new effects.AmbientOcclusion()] : [];
      byFarol();
      await Promise.resolve();
      byThree();
      for (const pause of ['after three', 'after Farol']) {
        const before = hostSnapshot(webgl, scene, camera);
        const image = byFarol();
        const after = hostSnapshot(webgl, scene, camera);
        const names = Object.keys({ ...before, ...after }).filter((name) => before[name] !== after[name]);
        const changed = names.map((name) => {
          let at = 0;
          while (before[name]?.[at] === after[name]?.[at]) at++;
          const part = (text = '') => text.slice(Math.max(0, at - 60), at + 60);
          return `${name}: ${part(before[name])} → ${part(after[name])}`;
        });
        results.push({ name: `${technique}, ${pause}`, changed, psnr: compareImages(stock, image).psnr });
      }
      const again = compareImages(stock, byThree()).largest;
      results.push({ name: `three after ${technique}`, changed: [], psnr: again === 0 ? Infinity : 0 });
    }
    return results;
  });
  for (const { name, changed, psnr } of results) {
    expect.soft(changed, name).toEqual([]);
    expect.soft(psnr, name).toBeGreaterThan(50);
  }
});
