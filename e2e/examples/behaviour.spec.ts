import { byExtent } from '@farol/tools/extent';
import type { Page } from '@playwright/test';
import { drawExample, openExample } from '../support/example';
import { compareImages } from '../support/images';
import { expect, test } from '../support/test';

/** Page position (CSS pixels) of the label that follows the knot. */
async function labelAt(page: Page): Promise<{ x: number; y: number }> {
  const box = await page.locator('.label').boundingBox();
  if (!box) throw new Error('The label is not on the page.');
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

test('controls: the gizmo drags the knot with its label, the orbit stays; beside the gizmo the view turns', async ({
  page,
}) => {
  await openExample(page, 'controls', 'deferred');
  const before = await drawExample(page, 'deferred');
  const label = await labelAt(page);
  expect(Math.abs(label.x - 160)).toBeLessThan(2); // over the knot, in the middle

  // the red arrow points to the right of the gizmo's centre
  const drag = async (fromX: number, fromY: number, byX: number) => {
    await page.mouse.move(fromX, fromY);
    await page.mouse.down();
    await page.mouse.move(fromX + byX / 2, fromY);
    await page.mouse.move(fromX + byX, fromY);
    await page.mouse.up();
    return drawExample(page, 'deferred');
  };
  const arrow = { x: 176, y: 84 };
  const moved = await drag(arrow.x, arrow.y, 40);
  expect(compareImages(before, moved).share).toBeGreaterThan(0.02);
  const after = await labelAt(page);
  expect(after.x - label.x).toBeGreaterThan(25);
  expect(Math.abs(after.y - label.y)).toBeLessThan(2);

  const turned = await drag(60, 160, 40);
  expect(compareImages(moved, turned).share).toBeGreaterThan(0.3);
});

test('stats: the panels count frames and draw calls while Farol draws @verify', async ({ page }) => {
  await page.setViewportSize({ width: 200, height: 120 });
  await page.goto('./examples/stats/index.html?technique=clustered-forward');
  await page.waitForFunction(() => 'example' in window);
  await page.evaluate(() => window.example.ready);
  await expect(page.locator('nav output')).toHaveText(/^[1-9]\d* draw calls$/);
  const panels = await page.locator('canvas').evaluateAll((all) => all.length);
  expect(panels).toBeGreaterThan(3);
});

test('r3f: what draws is switched while it runs, and what Farol held is freed @verify', async ({ page, watch }) => {
  await page.setViewportSize({ width: 200, height: 120 });
  await page.goto('./examples/r3f/index.html?technique=three');
  await page.waitForFunction(() => 'example' in window);
  await page.evaluate(() => window.example.ready);
  const drawnBy = page.getByRole('combobox', { name: 'Drawn by' });
  const held = () => page.evaluate(() => window.example.webgl.info.memory.textures);
  await expect.poll(() => page.evaluate(() => window.example.webgl.info.render.frame)).toBeGreaterThan(2);
  const before = await held();
  await drawnBy.selectOption('deferred');
  await expect.poll(() => page.evaluate(() => window.example.farol?.info.technique)).toBe('deferred');
  expect(await held()).toBeGreaterThan(before);
  await drawnBy.selectOption('tiled-forward');
  await expect.poll(() => page.evaluate(() => window.example.farol?.info.technique)).toBe('tiled-forward');
  await drawnBy.selectOption('three');
  await expect.poll(() => page.evaluate(() => window.example.farol === null)).toBe(true);
  expect(await held()).toBe(before);
  const frame = await page.evaluate(() => window.example.webgl.info.render.frame);
  await expect.poll(() => page.evaluate(() => window.example.webgl.info.render.frame)).toBeGreaterThan(frame);
  watch.forgive(/THREE\.Clock: This module has been deprecated/); // React Three Fiber uses THREE.Clock
});

test('r3f: an effect is put on and taken off, and outlives a Farol that was @verify', async ({ page, watch }) => {
  await openExample(page, 'r3f', 'deferred');
  const plain = await drawExample(page, 'deferred');
  const box = page.getByRole('checkbox', { name: 'SMAA' });
  await box.check();
  await expect.poll(() => page.evaluate(() => window.example.farol.effects.length)).toBe(1);
  const smooth = await drawExample(page, 'deferred');
  expect(compareImages(smooth, plain).largest).toBeGreaterThan(0.02); // edges
  await drawExample(page, 'three');
  const again = await drawExample(page, 'deferred');
  expect(await page.evaluate(() => window.example.farol.effects.length)).toBe(1);
  expect(compareImages(again, smooth).largest).toBe(0);
  await box.uncheck();
  await expect.poll(() => page.evaluate(() => window.example.farol.effects.length)).toBe(0);
  expect(compareImages(await drawExample(page, 'deferred'), plain).largest).toBe(0);
  watch.forgive(/THREE\.Clock: This module has been deprecated/); // React Three Fiber uses THREE.Clock
});

test('r3f: lights reach only what shares their layers where that is asked for', async ({ page, watch }) => {
  await page.setViewportSize({ width: 320, height: 180 });
  await page.goto('./examples/r3f/index.html?still&technique=deferred&layers');
  await page.waitForFunction(() => 'example' in window);
  await page.evaluate(() => window.example.ready);
  expect(await page.evaluate(() => window.example.farol.lightLayers)).toBe(true);
  // three has every light reach everything
  const all = await drawExample(page, 'three');
  // the code that tells layers apart is fetched late
  await expect.poll(async () => compareImages(await drawExample(page, 'deferred'), all).share).toBeGreaterThan(0.3);
  const layered = await drawExample(page, 'deferred');
  // the same as without the lanterns of the other layer
  const hidden = await page.evaluate(() => {
    let count = 0;
    window.example.scene!.traverse((object) => {
      if (!('isPointLight' in object) || object.layers.mask !== 2) return;
      object.visible = false;
      count++;
    });
    return count;
  });
  expect(hidden).toBe(12);
  expect(compareImages(layered, await drawExample(page, 'three')).psnr).toBeGreaterThan(60);
  watch.forgive(/THREE\.Clock: This module has been deprecated/);
});

test('without WebGL 2 every example says what to do', async ({ page, watch }) => {
  await page.addInitScript(() => {
    HTMLCanvasElement.prototype.getContext = () => null;
  });
  const others = ['attach-r3f', 'composer', 'controls', 'drei', 'gltf', 'mixed', 'postprocessing', 'stats'];
  for (const name of ['attach', 'r3f', ...byExtent({ slice: [], verify: others })]) {
    await page.goto(`./examples/${name}/index.html`);
    await expect(page.getByRole('alert'), name).toContainText(/WebGL 2.*hardware acceleration.*get\.webgl\.org/);
    expect(watch.forgive(/WebGL/), name).toBeGreaterThan(0);
  }
  // React and its renderer, of their own trouble
  watch.forgive(/THREE.Clock|error-boundaries/);
});

test('an address that names a technique or a part that there is not draws the page all the same', async ({
  page,
  watch,
}) => {
  for (const name of byExtent({ slice: ['r3f'], verify: ['r3f', 'drei', 'gltf'] })) {
    await page.goto(`./examples/${name}/index.html?still&technique=constructor&part=__proto__`);
    await expect(page.getByLabel('Drawn by'), name).toHaveValue('auto');
    await page.evaluate(() => window.example.ready);
    expect(await page.evaluate(() => window.example.farol.technique), name).toBe('auto');
  }
  watch.forgive(/THREE\.Clock: This module has been deprecated/);
});

test('r3f: one FarolRenderer serves the canvas, also while a sibling suspends @verify', async ({ page, watch }) => {
  await openExample(page, 'r3f', 'deferred');
  const plain = await drawExample(page, 'deferred');
  expect(await page.evaluate(() => window.example.made), 'under StrictMode').toBe(1);
  const during = await page.evaluate(async () => {
    const { example } = window;
    const { farol, webgl } = example;
    const textures = webgl.info.memory.textures;
    let end = () => {};
    example.suspend!(new Promise<void>((resolve) => (end = resolve)));
    while (example.farol === farol) await new Promise(requestAnimationFrame); // React takes refs away meanwhile
    const kept = webgl.info.memory.textures === textures;
    end();
    while (!example.farol) await new Promise(requestAnimationFrame);
    return { kept, same: example.farol === farol };
  });
  expect(during).toEqual({ kept: true, same: true });
  expect(compareImages(await drawExample(page, 'deferred'), plain).largest).toBe(0);
  await drawExample(page, 'clustered-forward');
  expect(await page.evaluate(() => window.example.made)).toBe(1);

  // Farol's replacements of render, compile and compileAsync are removed with it
  const own = () =>
    page.evaluate(() => {
      const { render, compile, compileAsync } = window.example.webgl;
      return [render, compile, compileAsync].map(String);
    });
  const withFarol = await own();
  await drawExample(page, 'three');
  const without = await own();
  for (const [i, text] of without.entries()) expect(text).not.toBe(withFarol[i]);
  await drawExample(page, 'deferred');
  expect(await own()).toEqual(withFarol);
  await drawExample(page, 'three');
  expect(await own()).toEqual(without);
  expect(await page.evaluate(() => window.example.made)).toBe(2);
  watch.forgive(/THREE\.Clock: This module has been deprecated/); // React Three Fiber uses THREE.Clock
});

test('r3f: edges are smooth where the canvas asks for it @verify', async ({ page, watch }) => {
  await page.setViewportSize({ width: 320, height: 180 });
  await page.goto('./examples/r3f/index.html?still&antialias&technique=three');
  await page.waitForFunction(() => 'example' in window);
  await page.evaluate(() => window.example.ready);
  const stock = await drawExample(page, 'three');
  // once the code of its light lists has come
  const forward = async () => compareImages(await drawExample(page, 'clustered-forward'), stock).psnr;
  await expect.poll(forward).toBeGreaterThan(60);
  const psnr = async () => compareImages(await drawExample(page, 'deferred'), stock).psnr;
  const passes = () => page.evaluate(() => window.example.farol.info.passes.map(({ name }) => name));
  await psnr(); // has the code of SMAA fetched
  await expect.poll(async () => (await psnr(), passes())).toContain('SMAA');
  const withEdges = await psnr();
  await page.evaluate(() => (window.example.farol.antialias = false));
  const without = await psnr();
  expect(withEdges - without, `${withEdges} dB, and ${without} without`).toBeGreaterThan(1);
  watch.forgive(/THREE\.Clock: This module has been deprecated/);
});
