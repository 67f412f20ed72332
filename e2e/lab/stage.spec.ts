import { byExtent } from '@farol/tools/extent';
import '../support/stage';
import { expect, test } from '../support/test';

declare global {
  interface Window {
    contexts: WebGL2RenderingContext[];
  }
}

/** All techniques of Farol, and three's own renderers. */
const farol = [
  'auto',
  'forward',
  'forward-single-pass',
  'deferred',
  'light-prepass',
  'inferred',
  'tiled-deferred',
].concat(['tiled-forward', 'forward-plus', 'clustered-deferred', 'clustered-forward']);

/**
 * Lowest PSNR to stock three (dB). Forward techniques compute the same in the same precision; G-buffers and sums of half
 * floats round by less than half an 8-bit step on average, which is 54 dB; `inferred` lights at half the resolution, so that
 * edges of planes differ.
 */
const likeness = (name: string): number => (name === 'inferred' ? 36 : 54);

test.beforeEach(async ({ page }) => {
  await page.addInitScript(() => {
    window.contexts = [];
    const { getContext } = HTMLCanvasElement.prototype;
    HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, ...args: unknown[]) {
      const context = (getContext as (...all: unknown[]) => RenderingContext | null).apply(this, args);
      if (context instanceof WebGL2RenderingContext) window.contexts.push(context);
      return context;
    } as typeof getContext;
  });
  await page.goto('./stage.html');
  await page.waitForFunction(() => 'stage' in window);
});

test('every competitor draws the picture of stock three, is timed and counted, and leaves nothing', async ({
  page,
}) => {
  const results = await page.evaluate(
    async (names) => {
      const stage = window.stage!;
      const { signal } = new AbortController();
      const scene = { name: 'benchmarkLights', parameters: { n: 3 } };
      const labCase = { scene, lights: 9, shadows: 0, overdraw: 0, width: 160, height: 90 };
      const psnr = (a: ImageData, b: ImageData) => {
        let sum = 0;
        for (let i = 0; i < a.data.length; i++) sum += (a.data[i] - b.data[i]) ** 2;
        return 10 * Math.log10((255 ** 2 * a.data.length * 0.75) / sum);
      };
      let reference: ImageData | null = null;
      const found = [];
      for (const name of names) {
        const { picture, ...opened } = await stage.open(name, labCase, { signal, longestFrame: 10_000 });
        reference ??= picture;
        const turn = await stage.turn(name, 20);
        const counts = await stage.count(name);
        const passes = name === 'deferred' ? await stage.passes(name) : null;
        const added = await stage.addLights(name);
        const changed = await stage.changeTechnique(name);
        stage.close(name);
        const size = [picture.width, picture.height];
        const brightest = Math.max(...picture.data.filter((_, i) => i % 4 !== 3));
        found.push({ name, ...opened, ...{ turn, counts, passes, added, changed, size, brightest } });
        Object.assign(found.at(-1)!, { psnr: psnr(picture, reference) });
      }
      return found as ((typeof found)[number] & { psnr: number })[];
    },
    ['stock', 'multipass', ...byExtent({ slice: ['auto', 'deferred'], verify: farol })],
  );
  for (const { name, psnr, turn, counts, passes, added, changed, ...rest } of results) {
    expect(psnr, name).toBeGreaterThan(likeness(name));
    expect(rest.size, name).toEqual([160, 90]);
    expect(rest.brightest, name).toBeGreaterThan(100);
    expect(rest.firstMs, name).toBeGreaterThan(0);
    expect(rest.technique, name).toEqual(name === 'auto' ? expect.stringMatching(/^clustered/) : kept(name));
    for (const kind of ['frame', 'cpu'] as const) {
      expect(turn[kind].length, `${name} ${kind}`).toBeGreaterThanOrEqual(3);
      expect(Math.min(...turn[kind]), `${name} ${kind}`).toBeGreaterThan(0);
    }
    // a software rasteriser has no GPU to time
    if (process.env.FAROL_GPU) expect(Math.min(...turn.gpu!), name).toBeGreaterThan(0);
    else expect(turn.gpu, name).toBeNull();
    // nine planes: drawn once, or once per light and once without lights
    const times = name === 'multipass' ? 10 : 1;
    expect(counts.draws, name).toBeGreaterThanOrEqual(9 * times);
    expect(counts.triangles, name).toBeGreaterThanOrEqual(18 * times);
    expect(counts.programs, name).toBeGreaterThan(0);
    if (farol.includes(name)) expect(counts.targetBytes, name).toBeGreaterThan(0);
    expect(added.ms, name).toBeGreaterThan(0);
    // only stock three compiles for added lights
    expect(added.programs > 0, name).toBe(name === 'stock');
    if (farol.includes(name)) expect(changed, name).toMatchObject({ ms: expect.any(Number), programs: 0 });
    else expect(changed, name).toBeNull();
    if (name === 'deferred') {
      expect(passes!.passes.map((pass) => pass.name)).toEqual(expect.arrayContaining(['g-buffer', 'light volumes']));
      expect(passes!.passes.every(({ ms }) => ms >= 0)).toBe(true);
    }
  }
  const contexts = await page.evaluate(() => window.contexts.map((gl) => gl.isContextLost()));
  expect(contexts.length).toBeGreaterThan(results.length);
  expect(contexts).not.toContain(false);
});

const kept = (name: string): string | null => (farol.includes(name) ? name : null);

test('moved lights change the picture; what cannot be drawn is refused in a sentence @verify', async ({ page }) => {
  const said = await page.evaluate(async () => {
    const stage = window.stage!;
    const { signal } = new AbortController();
    const scene = { name: 'benchmarkLights', parameters: { n: 1 } };
    const labCase = { scene, lights: 4, shadows: 0, overdraw: 0, width: 64, height: 36 };
    const open = (name: string, changes: object, options: object = {}) =>
      stage.open(name, { ...labCase, ...changes }, { signal, longestFrame: 10_000, ...options });
    const message = (work: Promise<unknown>) =>
      work.then(
        () => 'nothing',
        (error: Error) => error.message,
      );
    const pictures = [];
    for (let i = 0; i < 2; i++) pictures.push([...(await open('deferred', {})).picture.data].join());
    const drawn = async () => {
      const counted = stage.count('deferred');
      const { canvas } = window.contexts.at(-1)!;
      const picture = (canvas as HTMLCanvasElement).toDataURL();
      await counted;
      return picture;
    };
    const before = await drawn();
    await stage.turn('deferred', 30);
    const moved = (await drawn()) !== before;
    // shadow maps are drawn by WEBGL_multi_draw
    await open('deferred', { shadows: 1 });
    const shadowed = await stage.count('deferred');
    await open('deferred', {});
    const plain = await stage.count('deferred');
    stage.close('deferred');
    const cancelled = new AbortController();
    cancelled.abort(new Error('Cancelled.'));
    return {
      maps: shadowed.triangles - plain.triangles,
      same: pictures[0] === pictures[1],
      moved,
      lights: await message(open('stock', { lights: 3600 })),
      scene: await message(open('forward', { scene: { name: 'nowhere', parameters: {} } })),
      competitor: await message(open('unity', {})),
      compile: await message(open('stock', { lights: 400 }, { longestFrame: 1 })),
      cancelled: await message(open('forward', {}, { signal: cancelled.signal })),
      closed: await message(stage.turn('deferred', 10)),
      device: await stage.device(),
      available: await stage.unavailable('deferred'),
      alive: window.contexts.filter((gl) => !gl.isContextLost()).length,
    };
  });
  expect(said).toMatchObject({ same: true, moved: true, available: null, alive: 0, cancelled: 'Cancelled.' });
  expect(said.maps).toBeGreaterThan(0);
  expect(said.lights).toMatch(
    /^Its shader holds \d+ lights at most on this device \(\d+ uniform vectors\), not 3601\.$/,
  );
  expect(said.scene).toMatch(/^There is no scene ‘nowhere’: choose one of /);
  expect(said.competitor).toMatch(/^There is no competitor ‘unity’: choose one of /);
  expect(said.compile).toMatch(/^Left out: its shader with 401 lights takes about [\d.]+ s to compile here/);
  expect(said.closed).toBe('The competitor ‘deferred’ is not open: open it for a case first.');
  expect(said.device.renderer).not.toBe('');
  if (!process.env.FAROL_GPU) expect(said.device).toMatchObject({ software: true, timer: false });
});
