import { expect, test } from '../support/test';

test('every option is a property, of the same default and values; one that does not exist is named, with the nearest', async ({
  benchPage: page,
}) => {
  const seen = await page.evaluate(() => {
    const { effects, farol, three } = window.testPage;
    const webgl = new three.WebGLRenderer();
    const smaa = new effects.SMAA();
    const values: Required<import('@farol/renderer').FarolOptions> = {
      technique: 'deferred',
      view: 'albedo',
      quality: 'lite',
      budget: { frame: 8, min: 0.25, max: 0.75, sharpness: 0 },
      learning: true,
      timing: true,
      effects: [smaa],
      shadowAtlasSize: 1024,
      shadowCascades: 3,
      lightLayers: true,
      antialias: false,
      areaLightThreshold: 0.01,
      inferredScale: 1,
      heatMapMaximum: 8,
    };
    const names = Object.keys(values) as (keyof typeof values)[];
    const usual = new farol.FarolRenderer(webgl);
    const defaults = Object.fromEntries(names.map((name) => [name, usual[name]]));
    const wrong: string[] = [];
    for (const name of names) {
      const made = new farol.FarolRenderer(webgl, { [name]: values[name] });
      for (const other of names) {
        const expected = other === name ? values[other] : defaults[other];
        if (made[other] !== expected && JSON.stringify(made[other]) !== JSON.stringify(expected))
          wrong.push(`${other}, made with ${name}`);
      }
      Object.assign(usual, { [name]: values[name] });
      if (usual[name] !== values[name]) wrong.push(`${name}, set`);
    }
    const messageOf = (options: object) => {
      try {
        return String(new farol.FarolRenderer(webgl, options));
      } catch (error) {
        return (error as Error).message;
      }
    };
    return {
      defaults: { ...defaults, effects: (defaults.effects as unknown[]).length },
      wrong,
      misspelt: messageOf({ shadowCascade: 2 }),
      unknown: messageOf({ resolutionOfEverything: 1 }),
      undefinedValue: messageOf({ technique: undefined, inferredScale: undefined }),
      value: messageOf({ inferredScale: 2 }),
      quality: messageOf({ quality: 'lit' }),
      budget: messageOf({ budget: { frame: NaN } }),
    };
  });
  expect(seen.wrong).toEqual([]);
  expect(seen.defaults).toEqual({
    ...{
      technique: 'auto',
      view: 'final',
      quality: 'auto',
      budget: null,
      learning: false,
      timing: false,
      effects: 0,
      shadowAtlasSize: null,
      shadowCascades: 1,
    },
    ...{ lightLayers: false, antialias: true, areaLightThreshold: 0.0002, inferredScale: 0.5, heatMapMaximum: 32 },
  });
  expect(seen.misspelt).toMatch(
    /unknown option "shadowCascade"; use one of: technique, .* Is "shadowCascades" meant\?/,
  );
  expect(seen.unknown).toMatch(/unknown option "resolutionOfEverything"; use one of: technique, [^?]*\.$/);
  expect(seen.undefinedValue).toBe('[object Object]');
  expect(seen.quality).toMatch(/unknown quality "lit"; use one of: auto, full, lite\. Is "lite" meant\?/);
  expect(seen.budget).toMatch(/budget is { frame: NaN, .* }; give a frame above 0 ms/);
  expect(seen.value).toMatch(/inferredScale is 2; give a number above 0 and at most 1/);
});

test("setSize and setPixelRatio do what three's do, with the style of the canvas", async ({ benchPage: page }) => {
  const seen = await page.evaluate(() => {
    const { farol, three } = window.testPage;
    const webgl = new three.WebGLRenderer();
    const renderer = new farol.FarolRenderer(webgl);
    const { domElement: canvas } = webgl;
    const state = () => [canvas.width, canvas.height, canvas.style.width, canvas.style.height];
    renderer.setSize(80, 60);
    const first = state();
    renderer.setPixelRatio(2);
    const second = state();
    renderer.setSize(40, 30, false);
    return { first, second, third: state() };
  });
  expect(seen).toEqual({
    first: [80, 60, '80px', '60px'],
    second: [160, 120, '80px', '60px'],
    third: [80, 60, '80px', '60px'],
  });
});

test('shadowAtlasSize may change while frames are drawn: the picture is that of a renderer made with it', async ({
  benchPage: page,
}) => {
  const seen = await page.evaluate(async () => {
    const { Bench, compareImages, farol, isFlat, isSlice, shadowScene } = window.testPage;
    await farol.FarolRenderer.preload();
    const bench = new Bench(160, 120);
    bench.webgl.shadowMap.enabled = true;
    const { scene, camera } = shadowScene(160, 120, {
      caster: 'mixed',
      settings: { mapSize: 1024 },
      few: isSlice,
    });
    const drawnBy = (renderer: InstanceType<typeof farol.FarolRenderer>) =>
      bench.draw(() => renderer.render(scene, camera));
    const live = new farol.FarolRenderer(bench.webgl, { technique: 'deferred', shadowAtlasSize: 4096 });
    drawnBy(live);
    return [512, 2048, null].map((shadowAtlasSize) => {
      live.shadowAtlasSize = shadowAtlasSize;
      const fresh = new farol.FarolRenderer(bench.webgl, { technique: 'deferred', shadowAtlasSize });
      const [a, b] = [drawnBy(live), drawnBy(fresh)];
      const bytes = [live.info.shadows.bytes, fresh.info.shadows.bytes];
      fresh.dispose();
      return { flat: isFlat(a), largest: compareImages(a, b).largest, bytes };
    });
  });
  for (const { flat, largest, bytes } of seen) {
    expect(flat).toBe(false);
    expect(largest).toBe(0);
    expect(bytes[0]).toBe(bytes[1]);
  }
  expect(new Set(seen.map(({ bytes }) => bytes[0])).size).toBeGreaterThan(1);
});
