import { checkAgreement } from '../support/agreement';
import { expect, test } from '../support/benchTest';

test('the host finds its scene, renderer, device and three as they were, and stock three draws the same after Farol', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(() => {
    const { Bench, compareImages, fewMeshes, hostSnapshot, materialScene, techniquesInTurn, three } = window.testPage;
    const bench = new Bench(80, 60);
    const { scene, camera } = materialScene(80, 60, { count: 8, onlyDeferred: true, part: fewMeshes });
    // what Farol switches for a moment: nested lights, order, transmission, clearing
    const glass = new three.Mesh(new three.SphereGeometry(0.5), new three.MeshPhysicalMaterial({ transmission: 1 }));
    const hider = new three.Mesh(new three.PlaneGeometry(), new three.MeshStandardMaterial({ colorWrite: false }));
    hider.renderOrder = -1;
    const nested = new three.SpotLight(0xffffff, 5);
    nested.layers.enable(3);
    scene.add(glass, hider, new three.Group().add(nested));
    const { webgl } = bench;
    webgl.setClearColor(0x123456, 0.5);
    const first = bench.stock(scene, camera);
    // where three is kept from clearing: an opaque scene on the canvas
    const plain = new three.Scene();
    plain.background = new three.Color(0x203040);
    plain.add(new three.Mesh(new three.BoxGeometry(), new three.MeshStandardMaterial()), new three.PointLight());
    const clearingAfter = (technique: Parameters<typeof bench.byTechnique>[0]) => {
      webgl.autoClearStencil = false;
      bench.farol.technique = technique;
      webgl.setRenderTarget(null);
      bench.farol.render(plain, camera);
      const { autoClear, autoClearColor, autoClearDepth, autoClearStencil } = webgl;
      webgl.autoClearStencil = true;
      return [autoClear, autoClearColor, autoClearDepth, autoClearStencil];
    };
    return techniquesInTurn(3).map((technique) => {
      bench.byTechnique(technique, scene, camera);
      bench.stock(scene, camera);
      const before = hostSnapshot(webgl, scene, camera);
      bench.byTechnique(technique, scene, camera);
      const after = hostSnapshot(webgl, scene, camera);
      const names = Object.keys({ ...before, ...after }).filter((name) => before[name] !== after[name]);
      const changed = names.map((name) => {
        let at = 0;
        while (before[name]?.[at] === after[name]?.[at]) at++;
        const part = (text = '') => text.slice(Math.max(0, at - 60), at + 60);
        return `${name}: ${part(before[name])} → ${part(after[name])}`;
      });
      const again = compareImages(first, bench.stock(scene, camera)).largest;
      return { technique, changed, again, clearing: clearingAfter(technique) };
    });
  });
  for (const { technique, changed, again, clearing } of results) {
    expect.soft(changed, `${technique}: the host is as it was`).toEqual([]);
    expect(again, `${technique}: stock three afterwards`).toBe(0);
    expect(clearing, `${technique}: what three clears`).toEqual([true, true, true, false]);
  }
});

test('what a callback of the host draws inside a frame, by Farol or by stock three, is as in stock three', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(() => {
    const { Bench, compareImages, three } = window.testPage;
    const bench = new Bench(64, 48);
    const { webgl, farol } = bench;
    const scene = new three.Scene();
    const camera = new three.PerspectiveCamera(50, 64 / 48, 0.1, 50);
    camera.position.z = 5;
    const lamp = new three.PointLight(0xff4444, 20, 10);
    lamp.position.set(1, 1, 3);
    const mirrored = new three.WebGLRenderTarget(32, 24, { type: three.FloatType });
    const board = new three.Mesh(new three.PlaneGeometry(3, 2), new three.MeshBasicMaterial({ map: mirrored.texture }));
    board.position.set(1.2, 0.6, -1); // its middle shows the ball
    const ball = new three.Mesh(new three.SphereGeometry(0.7), new three.MeshStandardMaterial());
    const floor = new three.Mesh(new three.PlaneGeometry(9, 9), new three.MeshLambertMaterial());
    floor.position.z = -2;
    const lamps = [0, 1, 2].map((i) => new three.PointLight(0x44ff66, 9, 6).translateX(i - 1).translateZ(2));
    scene.add(new three.Group().add(lamp), ...lamps, board, ball, floor, new three.AmbientLight(0xffffff, 0.2));
    let by: { render(scene: unknown, camera: unknown): void } = webgl;
    const callback = () => {
      if (!board.visible) return;
      const target = webgl.getRenderTarget();
      board.visible = false;
      webgl.setRenderTarget(mirrored);
      by.render(scene, camera);
      webgl.setRenderTarget(target);
      board.visible = true;
    };
    const others = (['forward', 'deferred'] as const).map(
      (technique) => new window.testPage.farol.FarolRenderer(webgl, { technique }),
    );
    return [scene, board, ball].flatMap((place) => {
      place.onBeforeRender = callback;
      by = webgl;
      const wanted = bench.stock(scene, camera);
      const found = [webgl, farol, ...others].flatMap((one, i) =>
        (['forward-single-pass', 'forward', 'deferred'] as const).map((technique) => {
          by = one;
          const { psnr } = compareImages(wanted, bench.byTechnique(technique, scene, camera));
          const inner = ['three', 'the same', 'another, forward', 'another, deferred'][i];
          return { name: `${place.type}, ${inner} inside ${technique}`, psnr };
        }),
      );
      place.onBeforeRender = () => {};
      return found;
    });
  });
  for (const { name, psnr } of results) expect.soft(psnr, name).toBeGreaterThan(60);
});

test('classes of the host with accessors over private fields are drawn as stock three draws them, by each technique', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(() => {
    const { Bench, compareImages, drawn, effects, isFlat, privateScene, techniquesInTurn } = window.testPage;
    const bench = new Bench(96, 64);
    bench.webgl.shadowMap.enabled = true;
    bench.farol.inferredScale = 1;
    const { scene, camera, material } = privateScene(96, 64);
    const stock = bench.stock(scene, camera);
    const results = techniquesInTurn(1, drawn).map((technique) => ({
      technique,
      difference: compareImages(stock, bench.byTechnique(technique, scene, camera)),
    }));
    bench.farol.effects = [new effects.TAA()];
    const first = bench.byTechnique('deferred', scene, camera);
    bench.farol.effects = [];
    // live, and let go of with its source
    material.roughness = 0.9;
    const changed = bench.stock(scene, camera);
    const difference = compareImages(changed, bench.byTechnique('forward-plus', scene, camera));
    material.dispose();
    return { results, difference, flat: isFlat(stock), smoothed: compareImages(stock, first).psnr };
  });
  expect(results.flat).toBe(false);
  for (const { technique, difference } of results.results) checkAgreement(technique, difference, 'private fields');
  checkAgreement('forward-plus', results.difference, 'private fields, changed');
  // the first frame of it, moved by part of a pixel
  expect(results.smoothed, 'TAA').toBeGreaterThan(20);
});
