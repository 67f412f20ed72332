import { expect, test } from '../support/benchTest';

test('an effect that takes the picture over gives it back as it would have been: tone mapping, fog, viewport, pixel ratio, clearing', async ({
  benchPage: page,
}) => {
  const cases = await page.evaluate(() => {
    const { Bench, edgeScene, effects, techniquesInTurn, three } = window.testPage;
    const { scene, camera } = edgeScene(120, 80);
    scene.fog = new three.Fog(0x445566, 4, 14);
    const over = new three.Scene();
    over.add(new three.Mesh(new three.SphereGeometry(1), new three.MeshStandardMaterial({ color: 0x44ff44 })));
    over.add(new three.AmbientLight(0xffffff, 1));
    const { webgl, farol: renderer } = new Bench(120, 80, { renderer: { alpha: true } });
    webgl.setPixelRatio(1.5);
    webgl.setSize(120, 80, false);
    webgl.toneMapping = three.ACESFilmicToneMapping;
    webgl.toneMappingExposure = 1.2;
    const gl = webgl.getContext();
    const oit = new effects.WeightedBlendedOIT(); // with nothing transparent it changes nothing
    const read = () => {
      const data = new Uint8Array(180 * 120 * 4);
      gl.readPixels(0, 0, 180, 120, gl.RGBA, gl.UNSIGNED_BYTE, data);
      return data;
    };
    const apart = (draw: () => void) => {
      const [without, withEffect] = [[], [oit]].map((list) => {
        renderer.effects = list;
        webgl.setClearColor(0x000000, 0);
        webgl.clear();
        draw();
        return read();
      });
      let most = 0;
      let colours = 0;
      for (let i = 0; i < without.length; i++) {
        most = Math.max(most, Math.abs(without[i] - withEffect[i]));
        colours += without[i] > 0 ? 1 : 0;
      }
      return { most, drawn: colours / without.length };
    };
    const all = (technique: (typeof techniques)[number]) => {
      renderer.technique = technique;
      return {
        whole: apart(() => renderer.render(scene, camera)),
        viewport: apart(() => {
          webgl.setScissorTest(true);
          webgl.setScissor(20, 10, 60, 40);
          webgl.setViewport(20, 10, 60, 40);
          renderer.render(scene, camera);
          webgl.setScissorTest(false);
          webgl.setViewport(0, 0, 120, 80);
        }),
        overDrawn: apart(() => {
          webgl.render(scene, camera);
          webgl.autoClear = false;
          renderer.render(over, camera);
          webgl.autoClear = true;
        }),
        transparent: apart(() => renderer.render(over, camera)),
        depthLeft: apart(() => {
          renderer.render(scene, camera);
          webgl.autoClear = false;
          webgl.render(over, camera);
          webgl.autoClear = true;
        }),
      };
    };
    const techniques = ['deferred', 'clustered-forward', 'forward', 'light-prepass', 'tiled-deferred'] as const;
    return techniquesInTurn(0, techniques).map((technique) => [technique, all(technique)] as const);
  });
  for (const [technique, results] of cases) {
    for (const [name, { most, drawn }] of Object.entries(results)) {
      expect(drawn, `${technique}, ${name}: something is drawn`).toBeGreaterThan(0.02);
      // half floats of encoded colour
      expect(most, `${technique}, ${name}`).toBeLessThanOrEqual(2);
    }
  }
});

test('effects compile nothing once they have run, whatever is switched on and off, and free what they hold', async ({
  benchPage: page,
}) => {
  const result = await page.evaluate(() => {
    const { Bench, edgeScene, effects } = window.testPage;
    const bench = new Bench(64, 48);
    const { scene, camera, setTime } = edgeScene(64, 48);
    bench.stock(scene, camera);
    const host = bench.webgl.info.memory.textures;
    const lists = [
      [],
      [new effects.TAA()],
      [new effects.MultisampledEdges()],
      [new effects.AmbientOcclusion(), new effects.SMAA()],
      [new effects.WeightedBlendedOIT(), new effects.Decals()],
    ];
    const round = (start: number) => {
      lists.forEach((list, i) => {
        bench.farol.effects = list;
        for (let k = 0; k < 3; k++) {
          setTime(start + i + 0.1 * k);
          bench.byTechnique('deferred', scene, camera);
        }
      });
      return bench.programs;
    };
    round(0);
    const first = round(1);
    const second = round(2);
    const { textures } = bench.webgl.info.memory;
    for (const list of lists) for (const effect of list) effect.dispose();
    const freed = textures - bench.webgl.info.memory.textures;
    const held = bench.farol.effects.reduce((sum, { bytes }) => sum + bytes, 0);
    const again = round(3);
    bench.farol.dispose();
    for (const list of lists) for (const effect of list) effect.dispose();
    return { first, second, again, freed, held, left: bench.webgl.info.memory.textures - host };
  });
  expect(result.second).toBe(result.first);
  expect(result.again).toBe(result.first);
  expect(result.held).toBe(0);
  expect(result.freed).toBeGreaterThan(8);
  expect(result.left, 'textures that are left').toBe(0);
});

test('every effect draws again after a lost context, as before it', async ({ benchPage: page, watch }) => {
  const apart = await page.evaluate(async () => {
    const { Bench, compareImages, edgeScene, effects, three } = window.testPage;
    const bench = new Bench(96, 64, { losesContext: true });
    const { scene, camera } = edgeScene(96, 64);
    const decal = new effects.Decal(new three.MeshStandardMaterial({ color: 0x00ff00 }));
    decal.position.set(0, -1.6, 3);
    decal.rotation.x = -Math.PI / 2;
    const glass = new three.Mesh(
      new three.PlaneGeometry(1, 1),
      new three.MeshStandardMaterial({ transparent: true, opacity: 0.5 }),
    );
    glass.position.z = 3;
    scene.add(decal, glass);
    const { AmbientOcclusion, Decals, MultisampledEdges, TAA, WeightedBlendedOIT } = effects;
    const others = [new Decals(), new AmbientOcclusion(), new WeightedBlendedOIT()];
    const taa = new TAA();
    const edges = new MultisampledEdges();
    const draw = () => {
      let image!: ReturnType<typeof bench.byTechnique>;
      bench.farol.effects = [...others, taa];
      for (let i = 0; i < 4; i++) image = bench.byTechnique('deferred', scene, camera);
      bench.farol.effects = [...others, edges];
      return [image, bench.byTechnique('deferred', scene, camera)];
    };
    const before = draw();
    await bench.loseContext();
    return draw().map((image, i) => compareImages(before[i], image).psnr);
  });
  expect(Math.min(...apart)).toBeGreaterThan(50);
  expect(watch.forgive(/a WebGL context was lost|Context Lost|Context Restored/i)).toBeGreaterThan(0);
});

test('a technique from outside with a G-buffer pass of its own has ambient occlusion, decals and views; so has an effect depth', async ({
  benchPage: page,
}) => {
  const { largest, effects, faded } = await page.evaluate(() => {
    const { Bench, compareImages, edgeScene, effects, outside, three } = window.testPage;
    const bench = new Bench(96, 64);
    const { farol } = bench;
    const { scene, camera } = edgeScene(96, 64);
    const decal = new effects.Decal(new three.MeshStandardMaterial({ color: 0x00ff00 }));
    decal.position.set(0, -1.6, 3);
    decal.rotation.x = -Math.PI / 2;
    scene.add(decal);
    const own = farol.addTechnique('near-first', outside.nearFirst);
    const both = () => {
      const built = bench.byTechnique('deferred', scene, camera);
      return { built, apart: compareImages(built, bench.byTechnique(own, scene, camera)).largest };
    };
    const plain = both();
    farol.effects = [new effects.Decals(), new effects.AmbientOcclusion()];
    const withEffects = both();
    const largest = { plain: plain.apart, withEffects: withEffects.apart } as Record<string, number>;
    for (const view of ['albedo', 'lighting', 'light-count', 'overdraw', 'grid'] as const) {
      farol.view = view;
      largest[view] = both().apart;
    }
    farol.view = 'final';
    farol.effects = [new outside.DistanceFade()];
    const faded = both();
    largest.faded = faded.apart;
    return {
      largest,
      effects: compareImages(plain.built, withEffects.built).largest,
      faded: compareImages(plain.built, faded.built).largest,
    };
  });
  for (const [name, apart] of Object.entries(largest)) expect(apart, name).toBe(0);
  expect(effects, 'what ambient occlusion and a decal change').toBeGreaterThan(0.05);
  expect(faded, 'what the effect from outside changes').toBeGreaterThan(0.05);
});

test('SMAA keeps an edge beside one up to twice as strong, and leaves it to one that is stronger', async ({
  benchPage: page,
}) => {
  const changed = await page.evaluate(() => {
    const { Bench, effects, three } = window.testPage;
    const [width, height] = [48, 16];
    const bench = new Bench(width, height);
    const camera = new three.OrthographicCamera(0, width, height, 0, -1, 1);
    const grey = (value: number) =>
      new three.MeshBasicMaterial({ color: new three.Color().setRGB(value, value, value, three.SRGBColorSpace) });
    /** How many pixels of the lowest of three greys SMAA changes, which lie one over the other and step up by a pixel. */
    return [0.69, 0.75].map((highest) => {
      const scene = new three.Scene();
      scene.background = new three.Color().setRGB(0.4, 0.4, 0.4, three.SRGBColorSpace);
      for (const [left, bottom] of [
        [0, 8],
        [24, 9],
      ]) {
        // one row of the middle grey
        for (const [value, from] of [
          [0.5, bottom],
          [highest, bottom + 1],
        ]) {
          const part = new three.Mesh(new three.PlaneGeometry(24, height - from), grey(value));
          part.position.set(left + 12, (height + from) / 2, value - 0.5);
          scene.add(part);
        }
      }
      bench.farol.effects = [];
      const before = bench.byTechnique('deferred', scene, camera).data;
      bench.farol.effects = [new effects.SMAA()];
      const after = bench.byTechnique('deferred', scene, camera).data;
      const lowest = before[0];
      return before.filter((value, i) => i % 4 === 0 && Math.abs(value - lowest) < 1e-3 && after[i] > value + 1e-3)
        .length;
    });
  });
  // steps of 0.1 between the lower two, and of 0.19 or 0.25 between the upper two (display values)
  expect(changed[0]).toBeGreaterThan(0);
  expect(changed[1]).toBe(0);
});
