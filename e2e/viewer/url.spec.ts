import type { Light } from '@farol/engine';
import { compareImages, isFlat } from '../support/images';
import { expect, test } from '../support/test';
import { addressOf, openViewer, readImage, still } from '../support/viewer';

const small = { scene: 'benchmarkLights', width: 160, height: 90, dpr: 1 };

test('scene, technique, view, size, menu and the parameters of the scene come from the address', async ({ page }) => {
  await openViewer(page, {
    ...still,
    technique: 'forward',
    view: 'albedo',
    n: 3,
    m: 2,
    width: 120,
    height: 80,
    dpr: 1.5,
  });
  const seen = await page.evaluate(() => ({
    ...window.viewer.state,
    technique: window.viewer.farol.technique,
    view: window.viewer.farol.view,
    lights: window.viewer.engineScene.componentsOf<Light>('Light').filter(({ type }) => type === 'point').length,
  }));
  expect(seen).toMatchObject({ scene: 'benchmarkLights', technique: 'forward', view: 'albedo', lights: 4 });
  const image = await readImage(page);
  expect([image.width, image.height]).toEqual([180, 120]);
  expect(await page.locator('canvas').boundingBox()).toMatchObject({ width: 120, height: 80 });
  await expect(page.locator('.lil-gui.lil-root')).toBeHidden();
});

test('anti-aliasing and ambient occlusion come from the address, and the menu changes them', async ({ page }) => {
  await openViewer(page, { ...still, technique: 'deferred', aa: 'smaa', ao: 1, gui: 1 });
  const names = () => page.evaluate(() => window.viewer.farol.effects.map(({ name }) => name));
  expect(await names()).toEqual(['ambient occlusion', 'SMAA']);
  await page.getByLabel('Anti-aliasing').selectOption('TAA');
  await page.getByLabel('Ambient occlusion').uncheck();
  expect(await names()).toEqual(['TAA']);
  const { aa, ao } = await addressOf(page);
  expect([aa, ao]).toEqual(['taa', undefined]);
  expect(await page.evaluate(() => window.viewer.farol.info.passes.map(({ name }) => name))).toContain('TAA');
  const plain = await readImage(page);
  await page.getByLabel('Decals').check();
  await expect.poll(names).toEqual(['decals', 'TAA']);
  expect(compareImages(plain, await readImage(page)).largest, 'decals are seen').toBeGreaterThan(0.05);
  expect((await addressOf(page)).decals).toBe('1');
  const passes = await page.evaluate(() => window.viewer.farol.info.passes.map(({ name }) => name));
  expect(passes.filter((name) => name === 'decals')).toHaveLength(1);
  await page.getByLabel('Decals').uncheck();
  expect(await names()).toEqual(['TAA']);
});

test('the number of lights follows the address @verify', async ({ page }) => {
  for (const lights of [3, 17]) {
    await openViewer(page, { ...still, scene: 'temple', lights });
    const points = await page.evaluate(
      () => window.viewer.engineScene.componentsOf<Light>('Light').filter((l) => l.type === 'point').length,
    );
    expect(points).toBe(lights);
  }
});

test('without a size the picture fills the window and follows it', async ({ page }) => {
  await openViewer(page, { scene: 'benchmarkLights', time: 0, gui: 0 });
  expect(await page.locator('canvas').boundingBox()).toMatchObject({ width: 640, height: 360 });
  await page.setViewportSize({ width: 320, height: 200 });
  await expect.poll(() => page.locator('canvas').boundingBox()).toMatchObject({ width: 320, height: 200 });
});

test('a fixed time stands still: one frame is drawn, and none more, but by renderAt', async ({ page }) => {
  await openViewer(page, { ...small, time: 1.5, gui: 0 });
  const { before, after, time } = await page.evaluate(async () => {
    const { viewer } = window;
    const before = viewer.three.info.render.frame;
    // a loop that ran would draw in the next turn of the page
    await new Promise(requestAnimationFrame);
    const after = viewer.three.info.render.frame;
    return { before, after, time: viewer.engineScene.time };
  });
  expect(time).toBe(1.5);
  expect(after).toBe(before);
  expect(isFlat(await readImage(page))).toBe(false);

  const calls = await page.evaluate(() => {
    const { farol } = window.viewer;
    const render = farol.render.bind(farol);
    let calls = 0;
    farol.render = (...args) => {
      calls++;
      render(...args);
    };
    window.viewer.renderAt(3);
    return calls;
  });
  expect(calls).toBe(1);
});

test('without a time the scene moves @verify', async ({ page }) => {
  await openViewer(page, { ...small, gui: 0 });
  await expect.poll(() => page.evaluate(() => window.viewer.engineScene.time)).toBeGreaterThan(0.05);
});

test('wrong values are named on the page with the known ones, and the defaults are used', async ({ page }) => {
  await openViewer(page, { ...still, scene: 'palace', technique: 'magic', lights: 'many' });
  const message = page.locator('.message');
  await expect(message).toContainText('palace');
  await expect(message).toContainText('temple');
  await expect(message).toContainText('magic');
  await expect(message).toContainText('deferred');
  await expect(message).toContainText('lights=many');
  const state = await page.evaluate(() => window.viewer.state);
  expect(state).toMatchObject({ scene: 'temple', technique: 'auto', parameters: { n: 4 } });
  await message.getByRole('button').click();
  await expect(message).toBeHidden();
});

test('a browser without WebGL 2 is told so', async ({ page, watch }) => {
  await page.addInitScript(() => {
    HTMLCanvasElement.prototype.getContext = () => null;
  });
  await page.goto('./');
  await expect(page.locator('.message')).toContainText(/cannot start.*WebGL 2.*hardware acceleration/);
  expect(watch.forgive(/WebGL/)).toBeGreaterThan(0);
});

test('an address of another host in its path, unknown names and a size beyond the device are borne and told', async ({
  page,
  watch,
}) => {
  // the server may not know such a path: the page is that of the root
  await page.route(/\/\/x\/\?/, async (route) => {
    const root = new URL('/', route.request().url()).href;
    const response = await route.fetch({ url: root });
    const body = (await response.text()).replaceAll('./assets/', '/assets/');
    await route.fulfill({ response, body });
  });
  const query = new URLSearchParams({ ...Object.fromEntries(Object.entries(still).map(([k, v]) => [k, `${v}`])) });
  query.set('width', '8192');
  query.set('height', '4');
  query.set('dpr', '8');
  await page.goto(`.//x/?${query}&__proto__=1&constructor=2`);
  await page.evaluate(() => window.viewer.ready);
  expect(new URL(page.url()).pathname).toBe('//x/');
  expect((await addressOf(page)).scene).toBe('benchmarkLights');
  const messages = page.locator('.messages');
  await expect(messages).toContainText('__proto__ in the address is unknown and left out.');
  await expect(messages).toContainText('constructor in the address is unknown');
  await expect(messages).toContainText('The picture would have 65,536 × 32 pixels. It is drawn with');
  const drawn = await page.evaluate(() => {
    const gl = window.viewer.three.getContext();
    return { width: gl.drawingBufferWidth, most: gl.getParameter(gl.MAX_TEXTURE_SIZE) as number, error: gl.getError() };
  });
  expect(drawn).toMatchObject({ width: Math.min(drawn.most, 65_536), error: 0 });
  // the development server's own, of a page that it did not serve
  watch.forgive(/@vite\/client/);
});
