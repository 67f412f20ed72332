import { readdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import type { Locator, Page } from '@playwright/test';
import { expect, test } from '../support/test';
import {
  figureHash,
  type FigureWindow,
  type MultipassFigure,
  openFigure,
  type PhongFigure,
  readFigure,
  settle,
} from './openFigure';

test.use({ baseURL: process.env.FAROL_LIVE_URL, viewport: { width: 390, height: 560 } });

const folder = fileURLToPath(new URL('../../apps/site/live/thesis', import.meta.url));
const modules = readdirSync(folder)
  .filter((file) => file.endsWith('.ts') && !file.startsWith('figures'))
  .map((file) => file.slice(0, -'.ts'.length));

/** Passes of a frame, and shaders joined of pieces; the terms of a model have a test of their own. */
const inSlice = ['microshaders', 'multipass'];

/** How figures are opened so that each control has something to change. */
const queries: Record<string, string | undefined> = {
  // the order shows without the depth test
  depth: '&test=false',
  normals: '&normals=crease',
  pipeline: '&stage=primitives',
  // a graphics card's error at 32 bits is black
  position: '&show=error&bits=16',
  // planes fill the same floor, however many they are
  scenes: '&scene=benchmarkLightsObjects',
  steps: '&step=7',
};
/** Techniques whose steps are shown. */
const techniques = [
  ...['light-prepass', 'inferred', 'tiled-deferred', 'tiled-forward'],
  ...['forward-plus', 'clustered-deferred', 'clustered-forward'],
];

/** Moves a slider to its end, or to its beginning if it is there. @returns function that puts it back */
async function move(slider: Locator): Promise<() => Promise<void>> {
  const [value, most, least] = await slider.evaluate((input: HTMLInputElement) => [input.value, input.max, input.min]);
  await slider.fill(Number(value) === Number(most) ? least : most);
  return () => slider.fill(value);
}

/** Expects that each slider, box and row of buttons changes the picture, and that the first picture comes back. */
async function tryControls(page: Page): Promise<void> {
  const first = await figureHash(page);
  const changed = async (what: string): Promise<void> => {
    await settle(page);
    expect(await figureHash(page), `${what} changes the picture`).not.toBe(first);
  };
  for (const slider of await page.locator('.strip input[type=range]:visible').all()) {
    const back = await move(slider);
    await changed((await slider.getAttribute('name'))!);
    await back();
    await settle(page);
  }
  for (const box of await page.locator('.strip input[type=checkbox]:not([data-moves])').all()) {
    await box.click();
    await changed((await box.getAttribute('name'))!);
    await box.click();
    await settle(page);
  }
  expect(await figureHash(page), 'the first picture comes back').toBe(first);
  for (const row of await page.locator('.strip fieldset').all()) {
    const chosen = await row.locator('input:checked').getAttribute('value');
    const last = row.locator('input:not(:checked)').last();
    await last.check({ force: true });
    await changed((await last.getAttribute('name'))!);
    await row.locator(`[value="${chosen}"]`).check({ force: true });
    await settle(page);
  }
  const next = page.locator('button[name=next]');
  if ((await next.count()) === 0) return;
  await next.click();
  await changed('next');
}

/** Expects a picture of more than one tone, of which some are light. */
async function expectPicture(page: Page): Promise<void> {
  const { light, tones } = await readFigure(page);
  expect(tones).toBeGreaterThan(1);
  expect(light).toBeGreaterThan(0.002);
}

for (const name of modules) {
  test(`${name} draws, and each of its controls changes the picture${inSlice.includes(name) ? '' : ' @verify'}`, async ({
    page,
  }) => {
    await openFigure(page, name, queries[name]);
    await expectPicture(page);
    await tryControls(page);
  });
}

for (const technique of techniques) {
  test(`steps of ${technique} are pictures of their own @verify`, async ({ page }) => {
    await openFigure(page, 'steps', `&technique=${technique}`);
    const seen = new Set<number>();
    const steps = await page.locator('fieldset input').all();
    for (const step of steps) {
      await step.check({ force: true });
      await settle(page);
      await expectPicture(page);
      seen.add(await figureHash(page));
    }
    expect(seen.size).toBe(steps.length);
  });
}

test('a figure turns by arrow keys, and speaks Spanish @verify', async ({ page }) => {
  await openFigure(page, 'phong', '&lang=es&theme=light');
  const before = await figureHash(page);
  await page.locator('canvas').focus();
  await page.keyboard.press('ArrowLeft');
  expect(await figureHash(page)).not.toBe(before);
  await expect(page.getByText('Brillo')).toBeVisible();
});

test('a row of the tables is measured here, beside the figures of 2015 @verify', async ({ page }) => {
  await page.goto('./?thesis/results');
  await settle(page);
  const row = page.locator('tbody tr').first();
  await expect(row.locator('td').nth(2)).toHaveText('60');
  await row.getByRole('button').click();
  for (const cell of [4, 5, 6]) await expect(row.locator('td').nth(cell)).toHaveText(/^[\d.]+ ms · \d+$/);
});

/** Half a step of 8 bits for each picture that is added or compared. */
const roundings = (pictures: number): number => pictures / 2 / 255 + 1e-6;

test('Phong’s three terms add up to what stock three draws of the whole', async ({ page }) => {
  await openFigure(page, 'phong');
  const { largest, lit } = await page.evaluate(async () => {
    const { alone, camera, scene, set, webgl } = await (window as unknown as FigureWindow<PhongFigure>).live;
    const gl = webgl.getContext();
    webgl.outputColorSpace = 'srgb-linear';
    scene.background = null;
    const draw = (terms: Parameters<typeof set>[0]): Uint8Array => {
      set(terms);
      webgl.render(scene, camera);
      const data = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
      gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, data);
      return data;
    };
    scene.children.forEach((child) => child.children.forEach((bulb) => (bulb.visible = false)));
    const terms = (['ambient', 'diffuse', 'specular'] as const).map((term) => draw(alone(term)));
    const whole = draw({ ambient: true, diffuse: true, specular: true });
    let [largest, lit] = [0, 0];
    whole.forEach((value, i) => {
      // what is clamped, and alpha, adds up to nothing
      if (i % 4 === 3 || value > 250) return;
      const sum = terms.reduce((total, data) => total + data[i], 0);
      largest = Math.max(largest, Math.abs(sum - value) / 255);
      if (terms.every((data) => data[i] > 8)) lit++;
    });
    return { largest, lit };
  });
  expect(lit).toBeGreaterThan(100);
  expect(largest).toBeLessThanOrEqual(roundings(4));
});

test('the passes of multipass lighting add up to stock three’s frame @verify', async ({ page }) => {
  await openFigure(page, 'multipass');
  const { largest, lit, pictures } = await page.evaluate(async () => {
    const { camera, drawPass, drawSum, LIGHTS, scene, webgl } = await (
      window as unknown as FigureWindow<MultipassFigure>
    ).live;
    const gl = webgl.getContext();
    webgl.outputColorSpace = 'srgb-linear';
    scene.background = null;
    scene.traverse((object) => {
      if ('isPointLight' in object) object.children.forEach((bulb) => (bulb.visible = false));
    });
    const read = (): Uint8Array => {
      const data = new Uint8Array(4 * gl.drawingBufferWidth * gl.drawingBufferHeight);
      gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, data);
      return data;
    };
    const passes = Array.from({ length: LIGHTS + 1 }, (_, pass) => {
      drawPass(pass);
      return read();
    });
    drawSum(LIGHTS + 1); // all lights as the whole has them
    webgl.render(scene, camera);
    const whole = read();
    let [largest, lit] = [0, 0];
    whole.forEach((value, i) => {
      if (i % 4 === 3 || value > 245) return;
      const sum = passes.reduce((total, data) => total + data[i], 0);
      largest = Math.max(largest, Math.abs(sum - value) / 255);
      if (passes.filter((data) => data[i] > 8).length > 2) lit++;
    });
    return { largest, lit, pictures: LIGHTS + 2 };
  });
  expect(lit).toBeGreaterThan(100);
  expect(largest).toBeLessThanOrEqual(roundings(pictures));
});
