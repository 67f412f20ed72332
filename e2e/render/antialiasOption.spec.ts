import { isWhole } from '@farol/tools/extent';
import { expect, test } from '../support/benchTest';

const WIDTH = 240;
const HEIGHT = 160;

test('on a canvas with antialias, forward techniques are as stock three there, and deferred shading by MultisampledEdges', async ({
  benchPage: page,
}) => {
  const worst = await page.evaluate(
    ([width, height, techniques]) => {
      const { Bench, edgeScene, effects, techniquesInTurn, three } = window.testPage;
      const { scene, camera } = edgeScene(width, height);
      scene.background = null;
      const { webgl, farol: renderer } = new Bench(width, height, { renderer: { antialias: true, alpha: true } });
      webgl.toneMapping = three.NeutralToneMapping;
      const gl = webgl.getContext();
      const read = (draw: () => void) => {
        draw();
        const data = new Uint8Array(width * height * 4);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, data);
        return data;
      };
      const stock = read(() => webgl.render(scene, camera));
      return techniquesInTurn(1, techniques).map((technique) => {
        renderer.technique = technique;
        renderer.effects = technique === 'deferred' ? [new effects.MultisampledEdges()] : [];
        const image = read(() => renderer.render(scene, camera));
        return [technique, image.filter((value, i) => Math.abs(value - stock[i]) > 2).length / image.length] as const;
      });
    },
    // the others draw as these do
    [WIDTH, HEIGHT, ['forward', 'forward-single-pass', 'forward-plus', 'deferred'] as const] as const,
  );
  for (const [technique, difference] of worst) {
    // multipass resolves linear light before it is tone mapped and encoded, stock three afterwards: edges differ a little
    expect(difference, technique).toBeLessThanOrEqual(technique === 'forward' ? 0.08 : 1e-3);
  }
});

test('where canvas or target ask for samples, techniques that shade a G-buffer smooth edges by SMAA, unless an effect does or it is switched off', async ({
  benchPage: page,
}) => {
  const found = await page.evaluate(
    ([width, height]) => {
      const { Bench, compareImages, edgeScene, effects, isSlice, techniqueInTurn, three } = window.testPage;
      const { scene, camera } = edgeScene(width, height);
      const on = (bench: InstanceType<typeof Bench>, draw: () => void) => {
        const gl = bench.webgl.getContext();
        draw();
        const data = new Uint8Array(width * height * 4);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, data);
        return { width, height, data: Float32Array.from(data, (byte) => byte / 255) };
      };
      const smooth = new Bench(width, height, { renderer: { antialias: true } });
      const { webgl, farol } = smooth;
      const passes = () => farol.info.passes.filter(({ name }) => name === 'SMAA').length;
      const toCanvas = () => on(smooth, () => farol.render(scene, camera));
      const stock = on(smooth, () => webgl.render(scene, camera));
      const drawn: Record<string, { off: number; on: number; bySMAA: number; passes: number }> = {};
      const shading = ['deferred', 'tiled-deferred', 'clustered-deferred'] as const;
      for (const technique of techniqueInTurn(1, shading)) {
        farol.technique = technique;
        farol.antialias = false;
        farol.effects = [];
        const off = compareImages(stock, toCanvas()).psnr;
        farol.effects = [new effects.SMAA()];
        const wanted = toCanvas();
        farol.effects = [];
        farol.antialias = true;
        const image = toCanvas();
        const bySMAA = compareImages(wanted, image).largest;
        drawn[technique] = { off, on: compareImages(stock, image).psnr, bySMAA, passes: passes() };
      }
      const counts: Record<string, number> = {};
      const count = (name: string, draw: () => void = toCanvas) => {
        draw();
        counts[name] = passes();
      };
      const others = ['light-prepass', 'clustered-forward', 'forward', 'inferred'] as const;
      for (const technique of isSlice ? others.slice(0, 2) : others) {
        farol.technique = technique;
        count(technique);
      }
      farol.technique = 'deferred';
      const toTarget = (target: InstanceType<typeof three.WebGLRenderTarget<never>>) => () => {
        webgl.setRenderTarget(target as never);
        farol.render(scene, camera);
        webgl.setRenderTarget(null);
      };
      const type = three.HalfFloatType;
      count('target', toTarget(new three.WebGLRenderTarget(width, height, { type })));
      count('multisampled target', toTarget(new three.WebGLRenderTarget(width, height, { type, samples: 4 })));
      count('several', toTarget(new three.WebGLRenderTarget(width, height, { type, samples: 4, count: 2 })));
      farol.view = 'lighting';
      count('lighting');
      farol.view = 'final';
      farol.effects = [new effects.MultisampledEdges()];
      count('MultisampledEdges');
      farol.effects = [new effects.TAA()];
      count('TAA');
      farol.effects = [new effects.WeightedBlendedOIT()];
      count('WeightedBlendedOIT');
      farol.effects = [];
      count('once more');
      const bytes = farol.info.targetBytes;
      farol.antialias = false;
      const plain = new Bench(width, height);
      plain.farol.technique = 'deferred';
      on(plain, () => plain.farol.render(scene, camera));
      return { drawn, counts, bytes, plain: plain.farol.info.passes.map(({ name }) => name) };
    },
    [WIDTH, HEIGHT] as const,
  );
  for (const [technique, { off, on, bySMAA, passes }] of Object.entries(found.drawn)) {
    expect.soft(on, `${technique}: PSNR against stock three's canvas (dB), ${off} without`).toBeGreaterThan(off + 1);
    expect.soft(bySMAA, `${technique}: against the effect SMAA`).toBe(0);
    expect.soft(passes, technique).toBe(1);
  }
  expect(found.counts).toEqual({
    'light-prepass': 0,
    'clustered-forward': 0,
    ...(isWhole && { forward: 0, inferred: 0 }),
    target: 0,
    'multisampled target': 1,
    several: 0,
    lighting: 0,
    MultisampledEdges: 0,
    TAA: 0,
    WeightedBlendedOIT: 1,
    'once more': 1,
  });
  expect(found.plain).not.toContain('SMAA');
});

test('anti-aliasing does not come and go while auto changes between techniques with and without a G-buffer', async ({
  benchPage: page,
}) => {
  const found = await page.evaluate(
    async ([width, height]) => {
      const { Bench, compareImages, edgeScene, three } = window.testPage;
      const { scene, camera } = edgeScene(width, height);
      const { webgl, farol } = new Bench(width, height, { renderer: { antialias: true } });
      const gl = webgl.getContext();
      const read = (draw: () => void) => {
        draw();
        const data = new Uint8Array(width * height * 4);
        gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, data);
        return { width, height, data: Float32Array.from(data, (byte) => byte / 255) };
      };
      const lights = Array.from({ length: 12 }, (_, i) => {
        const light = new three.PointLight(0xffffff, 2, 20);
        light.position.set(i - 6, 3, 2);
        return light;
      });
      const found: { technique: string; off: number; on: number }[] = [];
      for (const many of [false, true, false]) {
        if (many) scene.add(...lights);
        else scene.remove(...lights);
        const wanted = many ? 'clustered-deferred' : 'forward-single-pass';
        farol.render(scene, camera);
        while (farol.info.technique !== wanted) {
          await new Promise(requestAnimationFrame);
          farol.render(scene, camera);
        }
        const stock = read(() => webgl.render(scene, camera));
        const psnr = () =>
          compareImages(
            stock,
            read(() => farol.render(scene, camera)),
          ).psnr;
        farol.antialias = false;
        const off = psnr();
        farol.antialias = true;
        found.push({ technique: farol.info.technique, off, on: psnr() });
      }
      return found;
    },
    [WIDTH, HEIGHT] as const,
  );
  const [first, second, third] = found;
  expect(found.map(({ technique }) => technique)).toEqual([
    'forward-single-pass',
    'clustered-deferred',
    'forward-single-pass',
  ]);
  // multisampled as stock three, whether SMAA is wanted or not
  for (const { off, on } of [first, third]) expect.soft([off > 60, on], 'PSNR (dB)').toEqual([true, off]);
  expect(second.on, 'PSNR (dB)').toBeGreaterThan(second.off + 1);
});

test('with effects of three in its output buffer, what antialias adds leaves them there', async ({
  benchPage: page,
}) => {
  const { calls, toneMapping } = await page.evaluate(() => {
    const { Bench, edgeScene, three } = window.testPage;
    const { scene, camera } = edgeScene(48, 32);
    const bench = new Bench(48, 32, { renderer: { antialias: true, outputBufferType: three.HalfFloatType } });
    const { webgl, farol } = bench;
    let calls = 0;
    const effect = {
      setSize() {},
      needsSwap: false,
      render() {
        calls++;
      },
    };
    webgl.setEffects([effect as never]);
    webgl.toneMapping = three.NeutralToneMapping;
    farol.technique = 'deferred';
    farol.render(scene, camera);
    farol.render(scene, camera);
    return { calls, toneMapping: webgl.toneMapping === three.NeutralToneMapping };
  });
  expect(calls).toBe(2);
  expect(toneMapping).toBe(true);
});
