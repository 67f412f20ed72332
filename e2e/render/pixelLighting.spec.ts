import { expect, test } from '../support/benchTest';

/** One step of an 8-bit picture, in linear light; of a pixel brighter than white that part of it. */
const LIMIT = 1 / 255;

test("the shares of a pixel's light add up to it, and a shadow takes all of its light's", async ({
  benchPage: page,
}) => {
  const { row, shaded, programs, kept, changed } = await page.evaluate(async () => {
    const { Bench, pixelScenes, techniqueInTurn, drawn } = window.testPage;
    const { checkPixels, shadedPixel } = await pixelScenes();
    const bench = new Bench(96, 64);
    const [technique] = techniqueInTurn(
      1,
      drawn.filter((name) => name.includes('deferred')),
    );
    const row = await checkPixels(bench, 'board', technique, 4);
    const before = bench.programs;
    return { row, ...(await shadedPixel(bench)), programs: bench.programs - before };
  });
  expect(row.difference, row.at).toBeLessThan(LIMIT);
  expect(row.lights).toBeGreaterThan(4);
  expect(row.programs).toBe(0);
  // one sun, whose shadow falls there, and a lamp without a shadow
  expect(shaded.map(({ type }) => type)).toEqual(['PointLight', 'DirectionalLight']);
  const [lamp, sun] = shaded;
  expect(sun.color).toEqual([0, 0, 0]);
  expect(sun.unshadowed[0]).toBeGreaterThan(0.1);
  expect(sun.distance).toBeNull();
  expect(lamp.share).toBeGreaterThan(0.5);
  expect(lamp.unshadowed).toEqual(lamp.color);
  expect(lamp.distance).toBeCloseTo(Math.hypot(1.5, 1, 0), 1);
  expect(programs).toBe(0);
  expect(kept).toBe(true);
  expect(changed).toBe(false);
});

const scenes = [
  ...['shadows', 'surroundings', 'field', 'areas', 'cookies'],
  ...['glass', 'orthographic', 'many', 'layered', 'probes'],
];

for (const name of scenes) {
  test(`shares add up to 20 pixels of a scene by every technique: ${name} @verify`, async ({ benchPage: page }) => {
    test.slow();
    const rows = await page.evaluate(async (scene) => {
      const { Bench, drawn, pixelScenes } = window.testPage;
      const { checkPixels } = await pixelScenes();
      const bench = new Bench(96, 64);
      const all = [];
      for (const technique of [...drawn, 'auto'] as const) all.push(await checkPixels(bench, scene, technique, 20));
      return all;
    }, name);
    expect(rows).toHaveLength(11);
    for (const row of rows) {
      expect.soft(row.difference, `${row.technique}: ${row.at}`).toBeLessThan(LIMIT);
      expect.soft(row.programs, row.technique).toBe(0);
      expect.soft(row.lights, row.technique).toBeGreaterThan(15);
    }
  });
}

test('occlusion, baked probes and blended layers count as in the picture; what gathers frames is named @verify', async ({
  benchPage: page,
}) => {
  test.slow();
  const rows = await page.evaluate(async () => {
    const { Bench, pixelScenes } = window.testPage;
    const { checkPixels } = await pixelScenes();
    const bench = new Bench(96, 64);
    const all = [];
    for (const technique of ['deferred', 'clustered-deferred'] as const)
      all.push(await checkPixels(bench, 'effects', technique, 12));
    return all;
  });
  for (const row of rows) {
    expect.soft(row.difference, row.at).toBeLessThan(LIMIT);
    expect(row.others).toContain('probes');
    expect(row.leftOut).toEqual([]);
  }
});

test('of many lights the brightest are told apart, the others are one share; work can be ended @verify', async ({
  benchPage: page,
}) => {
  const { few, rest, whole, ended, progress } = await page.evaluate(async () => {
    const { Bench, pixelScenes } = window.testPage;
    const { explainPixel, pixelScenes: scenes } = await pixelScenes();
    const bench = new Bench(96, 64);
    const { scene, camera } = scenes.layered(bench);
    bench.byTechnique('deferred', scene, camera);
    const at = { x: -0.1, y: -0.7 };
    const few = await explainPixel(bench.farol, scene, camera, at, { maxLights: 2 });
    const whole = await explainPixel(bench.farol, scene, camera, at);
    const control = new AbortController();
    const progress: number[] = [];
    const work = explainPixel(bench.farol, scene, camera, at, {
      signal: control.signal,
      onProgress: (done) => progress.push(done),
    });
    control.abort();
    const ended = await work.then(
      () => 'done',
      (error: Error) => error.name,
    );
    return {
      few: few.lights.map(({ share }) => share),
      rest: few.others.find(({ kind }) => kind === 'lights') ?? null,
      whole: whole.lights.map(({ share }) => share),
      ended,
      progress,
    };
  });
  expect(whole.length).toBeGreaterThan(3);
  expect(few).toHaveLength(2);
  expect(rest!.count).toBeGreaterThan(1);
  const sum = (shares: number[]): number => shares.reduce((all, share) => all + share, 0);
  expect(sum(few) + rest!.share).toBeCloseTo(sum(whole), 2);
  expect(ended).toBe('AbortError');
  expect(progress).toEqual([]);
});

test('what cannot be explained says why @verify', async ({ benchPage: page }) => {
  const messages = await page.evaluate(async () => {
    const { Bench, pixelScenes, three } = window.testPage;
    const { explainPixel, pixelScenes: scenes } = await pixelScenes();
    const bench = new Bench(32, 32);
    const { scene, camera } = scenes.many(bench);
    const tell = (work: Promise<unknown>): Promise<string> => work.then(String, (error: Error) => error.message);
    const { farol } = bench;
    const cases = [
      await tell(explainPixel(farol, scene, camera, { x: 0, y: 0 })),
      await tell(explainPixel(farol, scene, new three.ArrayCamera(), { x: 0, y: 0 })),
      await tell(explainPixel(farol, scene, camera, { x: 1.5, y: 0 })),
      await tell(explainPixel(farol, scene, camera, { x: 0, y: 0 }, { maxLights: 0 })),
    ];
    return cases;
  });
  expect(messages[0]).toContain('draw a frame first');
  expect(messages[1]).toContain('ArrayCamera');
  expect(messages[2]).toContain('from -1 to 1');
  expect(messages[3]).toContain('maxLights is 0');
});
