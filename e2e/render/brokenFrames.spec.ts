import { expect, test } from '../support/benchTest';

test('after any number of frames that a host’s code has broken, each technique draws as before, and the host is as it was', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(() => {
    const { Bench, breakFrames, brokenScene, compareImages, drawn, faultsOf, hostSnapshot, techniquesInTurn } =
      window.testPage;
    const bench = new Bench(96, 64);
    const { webgl } = bench;
    webgl.shadowMap.enabled = true;
    const broken = brokenScene(96, 64);
    const { scene, camera } = broken;
    const stock = bench.stock(scene, camera);
    const names = techniquesInTurn(4, drawn);
    const before = names.map((name) => {
      bench.byTechnique(name, scene, camera);
      return bench.byTechnique(name, scene, camera);
    });
    const inStock = breakFrames(
      faultsOf(broken, webgl, (s, c) => webgl.render(s, c)),
      24,
      1,
      () => bench.stock(scene, camera),
    );
    webgl.setRenderTarget(null);
    const faults = faultsOf(broken, webgl, (s, c) => bench.farol.render(s, c));
    const part = (text = '', other = '') => {
      let at = 0;
      while (at < text.length && text[at] === other[at]) at++;
      return text.slice(Math.max(0, at - 40), at + 40);
    };
    return names.map((name, i) => {
      const host = hostSnapshot(webgl, scene, camera);
      const messages = breakFrames(faults, 30, i + 1, () => bench.byTechnique(name, scene, camera));
      webgl.setRenderTarget(null);
      const after = hostSnapshot(webgl, scene, camera);
      return {
        name,
        difference: compareImages(before[i], bench.byTechnique(name, scene, camera)).largest,
        host: Object.keys(after)
          .filter((key) => host[key] !== after[key])
          .map((key) => `${key}: ${part(host[key], after[key])} → ${part(after[key], host[key])}`),
        messages: Object.keys(messages).filter((key) => messages[key] !== inStock[key]).map((key) => `${key}: ${inStock[key]} → ${messages[key]}`), // prettier-ignore
        stock: compareImages(stock, bench.stock(scene, camera)).psnr,
      };
    });
  });
  for (const { name, difference, host, messages, stock } of results) {
    expect.soft(difference, `${name}: the next good frame`).toBe(0);
    expect.soft(host, `${name}: the host`).toEqual([]);
    expect.soft(messages, `${name}: what reaches the host, in stock three and in Farol`).toEqual([]);
    expect.soft(stock, `${name}: stock three afterwards`).toBeGreaterThan(90);
  }
});

test('broken frames leave effects, the canvas with an output buffer, arrays of cameras and GPU times as they were @verify', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(async () => {
    const { Bench, breakFrames, brokenScene, compareImages, effects, faultsOf, three } = window.testPage;
    const bench = new Bench(96, 64, { renderer: { outputBufferType: three.HalfFloatType } });
    const { webgl, farol } = bench;
    webgl.shadowMap.enabled = true;
    webgl.toneMapping = three.NeutralToneMapping;
    const broken = brokenScene(96, 64);
    const { scene, camera } = broken;
    const decal = new effects.Decal(new three.MeshStandardMaterial({ color: 0xff0000 }));
    decal.position.set(0, 0.3, 0.7);
    decal.updateMatrixWorld();
    scene.add(decal);
    const gl = webgl.getContext() as WebGL2RenderingContext;
    const onCanvas = () => {
      webgl.setRenderTarget(null);
      farol.render(scene, camera);
      const data = new Uint8Array(96 * 64 * 4);
      gl.readPixels(0, 0, 96, 64, gl.RGBA, gl.UNSIGNED_BYTE, data);
      return { width: 96, height: 64, data: Float32Array.from(data, (byte) => byte / 255) };
    };
    const left = camera.clone() as InstanceType<typeof three.PerspectiveCamera> & { viewport: unknown };
    const right = left.clone() as typeof left;
    left.viewport = new three.Vector4(0, 0, 48, 64);
    right.viewport = new three.Vector4(48, 0, 48, 64);
    const both = new three.ArrayCamera([left, right] as never);
    const toTarget = (by: InstanceType<typeof three.Camera>) => () => bench.byTechnique(farol.technique, scene, by);
    const cases = [
      ['deferred', [new effects.AmbientOcclusion(), new effects.Decals(), new effects.WeightedBlendedOIT(), new effects.SMAA()], toTarget(camera)],
      ['forward-plus', [new effects.MultisampledEdges()], toTarget(camera)],
      ['clustered-forward', [], toTarget(both)],
      ['light-prepass', [new effects.AmbientOcclusion()], onCanvas],
      ['inferred', [], onCanvas],
    ] as const; // prettier-ignore
    farol.timing = true;
    const faults = faultsOf(broken, webgl, (s, c) => farol.render(s, c));
    const results: { name: string; difference: number; running: boolean; toneMapping: boolean }[] = [];
    for (const [technique, used, draw] of cases) {
      farol.technique = technique;
      farol.effects = used;
      await farol.compileAsync(scene, camera);
      // shadow maps at rest are looked at some frames later
      for (let i = 0; i < 3; i++) draw();
      const before = draw();
      breakFrames(faults, 30, 7, draw);
      const timer = gl.getExtension('EXT_disjoint_timer_query_webgl2') as { TIME_ELAPSED_EXT: number } | null;
      results.push({
        name: `${technique} with ${used.map(({ name }) => name).join()}`,
        running: timer !== null && gl.getQuery(timer.TIME_ELAPSED_EXT, gl.CURRENT_QUERY) !== null,
        toneMapping: webgl.toneMapping === three.NeutralToneMapping,
        difference: compareImages(before, draw()).largest,
      });
    }
    // what is compiled in advance by a broken scene
    scene.onBeforeRender = () => {
      throw new Error('thrown by the host');
    };
    const target = new three.WebGLRenderTarget(8, 8);
    webgl.setRenderTarget(target);
    const message = await farol.compileAsync(scene, camera).then(() => '', String);
    results.push({
      name: `compileAsync: ${message}`,
      difference: 0,
      running: webgl.getRenderTarget() !== target,
      toneMapping: message === 'Error: thrown by the host',
    });
    // temporal anti-aliasing: as in a renderer whose past is as long
    scene.onBeforeRender = () => undefined;
    farol.technique = 'tiled-deferred';
    const taa = new effects.TAA();
    farol.effects = [taa];
    const after = (frames: number) => {
      for (let i = 1; i < frames; i++) onCanvas();
      return onCanvas();
    };
    after(2);
    taa.reset();
    const fresh = after(6);
    breakFrames(faults, 30, 8, onCanvas);
    results.push({
      name: 'TAA',
      difference: compareImages(fresh, after(6)).largest,
      running: false,
      toneMapping: true,
    });
    return results;
  });
  for (const { name, difference, running, toneMapping } of results) {
    expect.soft(difference, `${name}: the next good frame`).toBe(0);
    expect.soft(running, `${name}: a query that runs, or another target`).toBe(false);
    expect.soft(toneMapping, `${name}: tone mapping`).toBe(true);
  }
});
