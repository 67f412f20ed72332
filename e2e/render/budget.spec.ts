import { expect, test } from '../support/benchTest';

const WIDTH = 240;
const HEIGHT = 160;
const LOST = /a WebGL context was lost|THREE\.WebGLRenderer: Context (Lost|Restored)/;

test('a scene is drawn at a scale as at that size, and then enlarged, by techniques with and without effects', async ({
  benchPage: page,
}) => {
  const found = await page.evaluate(
    ([width, height]) => {
      const { Bench, compareImages, edgeScene, effects, isSlice, three } = window.testPage;
      const scale = 0.7;
      const [w, h] = [Math.round(width * scale), Math.round(height * scale)];
      const { scene, camera } = edgeScene(width, height);
      const budget = { frame: 1e6, min: scale, max: scale, sharpness: 0.5 };
      const cases = {
        'forward-single-pass': () => [],
        'tiled-deferred': () => [new effects.AmbientOcclusion(), new effects.MultisampledEdges()],
        forward: () => [new effects.TAA({ cells: 1 })],
        ...(!isSlice && {
          deferred: () => [],
          'clustered-deferred': () => [new effects.SMAA()],
          'light-prepass': () => [new effects.WeightedBlendedOIT()],
        }),
      } as const;
      const flat = new three.OrthographicCamera(-1, 1, 1, -1, 0, 2);
      flat.position.z = 1;
      /** A picture that is drawn pixel by pixel. */
      const sheet = (data: Float32Array) => {
        const map = new three.DataTexture(data, w, h, three.RGBAFormat, three.FloatType);
        map.needsUpdate = true;
        const scene = new three.Scene();
        scene.add(
          new three.Mesh(new three.PlaneGeometry(2, 2), new three.MeshBasicMaterial({ map, toneMapped: false })),
        );
        return scene;
      };
      return Object.entries(cases).map(([technique, make]) => {
        const bench = new Bench(width, height);
        const { farol } = bench;
        farol.effects = make();
        farol.budget = budget;
        const scaled = bench.byTechnique(technique as 'forward', scene, camera);
        const info = { ...farol.info.budget! };
        farol.effects = make();
        farol.budget = null;
        bench.setSize(w, h);
        const small = bench.byTechnique(technique as 'forward', scene, camera);
        const off = farol.info.budget;
        farol.effects = [];
        farol.budget = budget;
        bench.setSize(width, height);
        const expected = bench.byTechnique('forward-single-pass', sheet(small.data), flat);
        bench.free();
        return { technique, info, off, ...compareImages(expected, scaled) };
      });
    },
    [WIDTH, HEIGHT] as const,
  );
  for (const { technique, info, off, largest, psnr } of found) {
    expect
      .soft(info, technique)
      .toEqual({ scale: 0.7, reason: 'the time of a frame is not known yet', ms: null, source: 'interval' });
    expect.soft(off, technique).toBeNull();
    // sums of half floats may be rounded to either side
    expect.soft(psnr, `${technique}: largest ${largest}`).toBeGreaterThan(60);
  }
});

// a picture of one sample a pixel is aliased at both sizes: no filter knows what lay between its samples
for (const [sheet, { temporal, antialias, better }] of [
  ['geometry', { temporal: true, antialias: false, better: 1.5 }],
  ['maps', { temporal: true, antialias: false, better: 1.5 }],
  ['geometry', { temporal: false, antialias: true, better: 1.5 }],
  ['maps', { temporal: false, antialias: true, better: 0.8 }],
] as const)
  test(`the sheet ${sheet}, enlarged from 0.7 ${temporal ? "by TAA's history" : 'along its edges'}, is nearer to its picture at full size than by bilinear filtering${temporal || sheet === 'maps' ? ' @verify' : ''}`, async ({
    benchPage: page,
  }) => {
    test.setTimeout(240_000);
    const { bilinear, enlarged } = await page.evaluate(
      ([sheet, options]) => window.testPage.enlargeSheet(sheet, 'forward-single-pass', 0.7, [0, 0.2], options),
      [sheet, { temporal, antialias }] as const,
    );
    for (const psnr of enlarged) expect.soft(psnr, `dB; bilinear ${bilinear}`).toBeGreaterThan(bilinear + better);
  });

test('once drawn at its largest scale, a scene drawn at any other allocates nothing, keeps depth for later draws, and TAA its past', async ({
  benchPage: page,
}) => {
  const found = await page.evaluate(
    ([width, height]) => {
      const { Bench, compareImages, edgeScene, effects, isSlice, three } = window.testPage;
      const { scene, camera } = edgeScene(width, height);
      const bench = new Bench(width, height);
      const { webgl, farol } = bench;
      const gl = webgl.getContext() as WebGL2RenderingContext;
      let allocations: string[] = [];
      const allocating = [
        'texStorage2D',
        'texImage2D',
        'renderbufferStorage',
        'renderbufferStorageMultisample',
      ] as const;
      for (const name of allocating) {
        const own = gl[name] as (...args: unknown[]) => void;
        Object.assign(gl, {
          [name]: (...args: unknown[]) => (allocations.push(`${name} ${args.slice(1, 6).join()}`), own.apply(gl, args)),
        });
      }
      const cases = {
        'clustered-deferred': () => [new effects.AmbientOcclusion(), new effects.SMAA()],
        'tiled-deferred': () => [new effects.TAA()],
        inferred: () => [],
        forward: () => [],
        // its targets are among those of the others
        ...(!isSlice && { 'clustered-forward': () => [] }),
      } as const;
      const allocated = Object.entries(cases).flatMap(([technique, make]) => {
        farol.effects = make();
        const draw = (scale: number) => {
          farol.budget = { frame: 1e6, min: scale, max: scale };
          return bench.byTechnique(technique as 'forward', scene, camera);
        };
        for (const scale of [1, 0.9, 1, 0.9]) draw(scale);
        allocations = [];
        for (const scale of [0.8, 0.62, 0.5, 0.73, 1, 0.9]) draw(scale);
        return allocations.map((call) => `${technique}: ${call}`);
      });
      // a wall behind all that was drawn shows nowhere but in the background
      farol.effects = [];
      farol.technique = 'deferred';
      farol.budget = { frame: 1e6, min: 0.5, max: 0.5 };
      scene.background = null;
      const wall = new three.Mesh(new three.PlaneGeometry(90, 90), new three.MeshBasicMaterial({ color: 0x00ff00 }));
      wall.position.z = -20;
      const after = bench.draw(() => {
        farol.render(scene, camera);
        webgl.autoClear = false;
        const walls = new three.Scene();
        walls.add(wall);
        webgl.render(walls, camera);
        webgl.autoClear = true;
      });
      scene.add(wall);
      const within = bench.draw(() => farol.render(scene, camera));
      // TAA across a step of the scale: as smooth as before
      scene.remove(wall);
      farol.effects = [new effects.TAA()];
      const steady = (scale: number, frames: number) => {
        farol.budget = { frame: 1e6, min: scale, max: scale };
        let image = bench.draw(() => farol.render(scene, camera));
        for (let i = 1; i < frames; i++) image = bench.draw(() => farol.render(scene, camera));
        return image;
      };
      const settled = steady(46 / 64, 40);
      const stepped = steady(45 / 64, 1);
      farol.effects = [new effects.TAA()];
      const anew = steady(45 / 64, 1);
      const psnr = (image: typeof anew) => compareImages(settled, image).psnr;
      return { allocated, covered: compareImages(within, after).psnr, stepped: psnr(stepped), anew: psnr(anew) };
    },
    // half as large: a hundred frames, whose pixels are no subject
    [WIDTH / 2, HEIGHT / 2] as const,
  );
  expect(found.allocated).toEqual([]);
  // edges of the wall are enlarged in one, and drawn at full size in the other
  expect(found.covered).toBeGreaterThan(18);
  expect(found.stepped, `dB; without a past ${found.anew}`).toBeGreaterThan(found.anew + 6);
});

test('targets that cannot be scaled are drawn whole, a lost context comes back, and a tab that slept changes nothing', async ({
  benchPage: page,
  watch,
}) => {
  const found = await page.evaluate(
    async ([width, height]) => {
      const { Bench, compareImages, edgeScene, three } = window.testPage;
      const { scene, camera } = edgeScene(width, height);
      const bench = new Bench(width, height, { losesContext: true });
      const { webgl, farol } = bench;
      farol.budget = { frame: 1e6, min: 0.6, max: 0.6 };
      const reasonOf = (target: InstanceType<typeof three.WebGLRenderTarget<never>>) => {
        webgl.setRenderTarget(target as never);
        farol.render(scene, camera);
        webgl.setRenderTarget(null);
        return { ...farol.info.budget! };
      };
      const whole = [
        new three.WebGLRenderTarget(64, 64, { count: 2 }),
        new three.WebGLCubeRenderTarget(64),
        new three.WebGLRenderTarget(16, 16),
      ].map((target) => reasonOf(target as never));
      const before = bench.byTechnique('deferred', scene, camera);
      bench.webgl.domElement.addEventListener('webglcontextlost', () => bench.target.dispose());
      await bench.loseContext();
      const after = bench.byTechnique('deferred', scene, camera);
      return { whole, scale: farol.info.budget!.scale, lost: compareImages(before, after).largest };
    },
    [WIDTH, HEIGHT] as const,
  );
  expect(watch.forgive(LOST)).toBeGreaterThanOrEqual(1);
  expect(found.whole.map(({ scale }) => scale)).toEqual([1, 1, 1]);
  expect(found.whole.map(({ reason }) => reason)).toEqual([
    'the target has several textures',
    'the target is part of a cube, an array or mipmaps',
    'the picture is small',
  ]);
  expect(found.scale).toBe(0.6);
  expect(found.lost).toBe(0);
});
