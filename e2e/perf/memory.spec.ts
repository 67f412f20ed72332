import { isWhole } from '@farol/tools/extent';
import { budgetOf } from './budgets';
import { expect, test } from './perfTest';

test('targets take no more a pixel than each technique may, are told truly, and go with dispose', async ({ page }) => {
  const measured = await page.evaluate(() => {
    const { perf } = window;
    perf.drawNothing(); // what is sent and held does not hang on it
    const [width, height] = [160, 90];
    perf.world('forward-single-pass', { width, height }).draw(); // what three itself makes once
    return perf.techniques.map((technique) => {
      const before = perf.textureBytes();
      const world = perf.world(technique, { objects: 4, lights: 1000, width, height });
      const { info } = world.farol;
      // light data may take turns between textures: lights that move bring all of them out
      const draw = () => {
        for (let i = 0; i < 4; i++) {
          for (const light of world.lights) light.position.x += 0.001;
          world.draw();
        }
      };
      draw();
      const small = { counted: perf.textureBytes() - before, told: info.targetBytes, drawn: info.technique };
      world.setSize(2 * width, 2 * height);
      draw();
      const large = { counted: perf.textureBytes() - before, told: info.targetBytes, drawn: info.technique };
      world.dispose();
      const pixels = 3 * width * height;
      const left = perf.textureBytes() - before;
      return { technique, small, large, pixels, left };
    });
  });
  for (const { technique, small, large, pixels, left } of measured) {
    const perPixel = (large.counted - small.counted) / pixels;
    const seen = `${technique}: ${perPixel.toFixed(2)} bytes a pixel`;
    test.info().annotations.push({ type: 'memory', description: `${seen}, ${small.told} at 160 × 90` });
    // auto may pick another technique for another size
    if (small.drawn === large.drawn) expect(perPixel, seen).toBeLessThanOrEqual(budgetOf(small.drawn).bytesPerPixel);
    // room that is set aside and not drawn to yet may be told, but nothing may be kept quiet
    expect(small.told, `${technique}: bytes that Farol tells of`).toBeGreaterThanOrEqual(small.counted);
    expect(small.told, `${technique}: bytes that Farol tells of`).toBeLessThanOrEqual(1.3 * small.counted);
    expect(left, `${technique}: bytes left after dispose`).toBe(0);
  }
});

test('info tells the bytes of everything: their sum is that of all textures and renderbuffers that WebGL was asked for', async ({
  page,
}) => {
  const few = !isWhole;
  const measured = await page.evaluate(async (few) => {
    const { perf, testPage } = window;
    const { three, farol: package_, shadowScene } = testPage;
    await package_.FarolRenderer.preload();
    const [width, height] = [160, 90];
    const webgl = new three.WebGLRenderer({ antialias: false });
    webgl.setSize(width, height, false);
    webgl.shadowMap.enabled = true;
    const { scene, camera, lights } = shadowScene(width, height, {
      caster: 'mixed',
      settings: { mapSize: 256 },
      few,
    });
    const stock = new package_.FarolRenderer(webgl, { technique: 'forward-single-pass' });
    scene.traverse((object) => (object.castShadow = false));
    stock.render(scene, camera); // what three itself makes once
    stock.dispose();
    for (const light of lights) light.castShadow = true;
    // the first test has the targets of the others
    const shown = perf.techniques.filter((name) => !few || /^(clustered-forward|tiled-deferred|inferred)$/.test(name));
    return shown.flatMap((technique, turn) =>
      (few ? [(['full', 'lite'] as const)[turn % 2]] : (['full', 'lite'] as const)).map((quality) => {
        const before = perf.textureBytes();
        const farol = new package_.FarolRenderer(webgl, { technique, quality });
        // light data may take turns between textures: lights that move bring all of them out
        for (let i = 0; i < 4; i++) {
          for (const light of lights) light.position.x += 0.01;
          farol.render(scene, camera);
        }
        const counted = perf.textureBytes() - before;
        const { memory, quality: drawn, targetBytes: total } = farol.info;
        const told = { ...memory };
        farol.dispose();
        return { technique, quality, drawn, counted, told, total };
      }),
    );
  }, few);
  expect(measured.length).toBeGreaterThan(few ? 2 : 4);
  for (const { technique, quality, drawn, counted, told, total } of measured) {
    const said = `${technique}, ${quality}: ${JSON.stringify(told)}`;
    const { gbufferPixel, ...parts } = told;
    expect.soft(drawn).toBe(quality);
    expect.soft(total, said).toBe(counted);
    expect.soft(total, said).toBe(Object.values(parts).reduce((sum, bytes) => sum + bytes));
    if (told.gbuffer > 0) expect.soft(gbufferPixel, said).toBe(quality === 'lite' ? 14 : 20);
  }
});

test('with the quality lite all targets and shadow maps of 32 lights take at most 64 MB at 1920 × 1080 @verify', async ({
  page,
}) => {
  test.setTimeout(120_000);
  const measured = await page.evaluate(async (few) => {
    const { perf, testPage } = window;
    const { three, farol: package_, shadowScene } = testPage;
    await package_.FarolRenderer.preload();
    const webgl = new three.WebGLRenderer({ antialias: false });
    const [width, height] = [1920, 1080];
    webgl.setSize(width, height, false);
    webgl.shadowMap.enabled = true;
    perf.drawNothing(); // what is held does not hang on it
    const { scene, camera } = shadowScene(width, height, { caster: 'spot', few });
    for (let i = 0; i < 32; i++) {
      const light = i % 2 > 0 ? new three.SpotLight(0xffffff, 9, 12, 0.7) : new three.PointLight(0xffffff, 9, 12);
      light.castShadow = true;
      light.shadow.mapSize.setScalar(1024);
      light.position.set(i / 4 - 4, 3, 1);
      scene.add(light);
    }
    const techniques = ['tiled-deferred', 'clustered-forward', 'auto', 'clustered-deferred'] as const;
    return techniques.slice(0, few ? 2 : 4).map((technique) => {
      const before = perf.textureBytes();
      const farol = new package_.FarolRenderer(webgl, { technique, quality: 'lite' });
      for (let i = 0; i < 4; i++) farol.render(scene, camera);
      const counted = perf.textureBytes() - before;
      const { targetBytes, shadows, memory } = farol.info;
      const drawn = shadows.drawn + shadows.kept;
      const perPixel = memory.gbuffer / (width * height);
      farol.dispose();
      return { technique, counted, targetBytes, drawn, perPixel };
    });
  }, !isWhole);
  for (const { technique, counted, targetBytes, drawn, perPixel } of measured) {
    const said = `${technique}: ${(targetBytes / 1e6).toFixed(1)} MB, ${(counted / 1e6).toFixed(1)} counted`;
    test.info().annotations.push({ type: 'memory', description: said });
    expect.soft(drawn, said).toBeGreaterThanOrEqual(32);
    expect.soft(Math.max(targetBytes, counted), said).toBeLessThanOrEqual(64e6);
    expect.soft(perPixel, `${said}, G-buffer and depth`).toBeLessThanOrEqual(18);
  }
});
