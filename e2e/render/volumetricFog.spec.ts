import { expect, test } from '../support/benchTest';

test('fog is alike over a G-buffer and forward, and gone with its effect', async ({ benchPage: page }) => {
  const { agreement, shown, gone } = await page.evaluate(async () => {
    const { FogScene, compareImages, farol } = window.testPage;
    await farol.FarolRenderer.preload();
    const fogScene = new FogScene(64, 40);
    const { bench, scene, camera } = fogScene;
    const bare = bench.byTechnique('deferred', scene, camera);
    const image = fogScene.byFarol('deferred', 2);
    const agreement = compareImages(image, fogScene.byFarol('forward-single-pass', 2)).psnr;
    bench.farol.effects = [];
    const without = bench.byTechnique('deferred', scene, camera);
    return { agreement, shown: compareImages(bare, image).psnr, gone: compareImages(bare, without).psnr };
  });
  // a G-buffer rounds what it keeps
  expect(agreement).toBeGreaterThan(50);
  expect(shown).toBeLessThan(25);
  expect(gone).toBeGreaterThan(60);
});

test('fog is alike under every technique @verify', async ({ benchPage: page }) => {
  const rows = await page.evaluate(async () => {
    const { FogScene, compareImages, drawn, farol } = window.testPage;
    await farol.FarolRenderer.preload();
    const fogScene = new FogScene(128, 72);
    const bare = fogScene.bench.stock(fogScene.scene, fogScene.camera);
    const first = fogScene.byFarol('deferred', 3);
    return drawn.map((technique) => {
      const image = fogScene.byFarol(technique, 3);
      return { technique, psnr: compareImages(first, image).psnr, shown: compareImages(bare, image).psnr };
    });
  });
  expect(rows).toHaveLength(10);
  for (const { technique, psnr, shown } of rows) {
    // inferred lighting lights at half the resolution
    expect.soft(psnr, technique).toBeGreaterThan(technique === 'inferred' ? 35 : 60);
    expect.soft(shown, technique).toBeLessThan(25);
  }
});

test('fog frees what it holds, and is the same when it is drawn again @verify', async ({ benchPage: page }) => {
  const { held, freed, textures, again } = await page.evaluate(async () => {
    const { FogScene, compareImages, farol } = window.testPage;
    await farol.FarolRenderer.preload();
    const fogScene = new FogScene(64, 40);
    const { bench, fog, scene, camera } = fogScene;
    bench.byTechnique('deferred', scene, camera);
    const { memory } = bench.webgl.info;
    const before = memory.textures;
    const first = fogScene.byFarol('deferred', 2);
    const held = fog.bytes;
    bench.farol.effects = [];
    fog.dispose();
    const [freed, textures] = [fog.bytes, memory.textures - before];
    return { held, freed, textures, again: compareImages(first, fogScene.byFarol('deferred', 2)).psnr };
  });
  expect(held).toBeGreaterThan(3 * 8 * 5 * 64 * 8);
  expect(freed).toBe(0);
  expect(textures).toBe(0);
  expect(again).toBeGreaterThan(80);
});

test('fog is drawn again when a lost context is back @verify', async ({ benchPage: page, watch }) => {
  const psnr = await page.evaluate(async () => {
    const { FogScene, compareImages, farol } = window.testPage;
    await farol.FarolRenderer.preload();
    const fogScene = new FogScene(64, 40);
    const first = fogScene.byFarol('deferred', 2);
    await fogScene.bench.loseContext();
    return compareImages(first, fogScene.byFarol('deferred', 2)).psnr;
  });
  expect(psnr).toBeGreaterThan(60);
  expect(watch.forgive(/WebGL context was lost|Context Lost|Context Restored/i)).toBeGreaterThanOrEqual(1);
});

test('a lamp of a light field lights fog as a PointLight does @verify', async ({ benchPage: page }) => {
  const rows = await page.evaluate(async () => {
    const { Bench, compareImages, effects, farol, lightFields, three } = window.testPage;
    await farol.FarolRenderer.preload();
    const bench = new Bench(64, 40);
    const camera = new three.PerspectiveCamera(60, 1.6, 0.1, 50);
    const scene = new three.Scene();
    const lamp = new three.PointLight(new three.Color(1, 0.6, 0.3), 12, 6);
    lamp.position.set(0.5, 0.2, -4);
    const field = new lightFields.LightField(2);
    field.setPoint(0, 0.5, 0.2, -4, 6, 12, 7.2, 3.6);
    const fog = new effects.VolumetricFog();
    Object.assign(fog, { density: 0.1, distance: 12, frames: 1, time: 0, froxels: [16, 10, 64] });
    bench.farol.effects = [fog];
    return (['deferred', 'clustered-forward'] as const).map((technique) => {
      scene.clear().add(lamp);
      const one = bench.byTechnique(technique, scene, camera);
      scene.clear().add(field);
      const other = bench.byTechnique(technique, scene, camera);
      return { psnr: compareImages(one, other).psnr, brightest: Math.max(...one.data) };
    });
  });
  for (const { psnr, brightest } of rows) {
    expect(brightest).toBeGreaterThan(0.05);
    expect.soft(psnr).toBeGreaterThan(60);
  }
});

for (const technique of ['deferred', 'clustered-forward'] as const) {
  test(`fog by ${technique} is what a march of 512 steps gives, at rest and in motion @verify`, async ({
    benchPage: page,
  }) => {
    test.slow();
    const { still, moving } = await page.evaluate(async (name) => {
      const { FogScene, compareImages, farol } = window.testPage;
      await farol.FarolRenderer.preload();
      const fogScene = new FogScene();
      const { camera } = fogScene;
      const march = fogScene.byMarch();
      const rest = compareImages(march, fogScene.byFarol(name, 48)).psnr;
      const { x, z } = camera.position;
      const turn = camera.rotation.y;
      const picture = fogScene.byFarol(name, 16, (frame) => {
        camera.position.x = x + (15 - frame) * 0.02;
        camera.position.z = z + (15 - frame) * 0.03;
        camera.rotation.y = turn - (15 - frame) * 0.004;
      });
      return { still: rest, moving: compareImages(march, picture).psnr };
    }, technique);
    expect.soft(still).toBeGreaterThanOrEqual(38);
    expect.soft(moving).toBeGreaterThanOrEqual(32);
    test.info().annotations.push({ type: 'dB', description: `${still.toFixed(1)}, moving ${moving.toFixed(1)}` });
  });
}
