import { pathToFileURL } from 'node:url';
import type { Light, SunAndMoon } from '@farol/engine';
import type { Page } from '@playwright/test';
import { addObject, history } from './editor';
import { pixelAt } from './models';
import { playerPicture } from './player';
import { expect, test } from './sharedEditor';

test.use({ viewport: { width: 1280, height: 800 } });

/** Intensity, colour and stored fields of the point light. */
const lamp = (page: Page): Promise<{ type: string; candela: number; blue: number; unit: string; kelvin: number }> =>
  page.evaluate(() => {
    const light = window.editor.document.selectedObjects[0].getComponent('Light') as Light;
    const { intensity, color } = light.three;
    const { type, intensityUnit: unit, kelvin } = light;
    return { type, candela: intensity, blue: color.b / color.r, unit, kelvin };
  });

test('a light is a bulb of 60 W, is shown in lumens and dimmed in them, and turns cold by kelvin; a step each', async ({
  page,
}) => {
  await addObject(page, 'Light', 'Point light');
  const before = await lamp(page);
  const steps = (await history(page)).length;
  const inspector = page.getByRole('region', { name: 'Inspector' });
  const row = inspector.locator('[data-field="intensity"]');

  await inspector.getByRole('button', { name: 'Presets' }).click();
  await page.getByRole('menuitem', { name: '60 W bulb' }).click();
  await expect(row.getByRole('textbox')).toHaveValue('60');
  const bulb = await lamp(page);
  expect(bulb).toMatchObject({ type: 'point', unit: 'watt', kelvin: 2700 });
  expect(bulb.candela).toBeCloseTo(800 / (4 * Math.PI), 2);
  expect(bulb.blue).toBeLessThan(0.15);

  await row.getByRole('button', { name: 'W Incandescent' }).click();
  await page.getByRole('menuitemcheckbox', { name: 'Lumen (lm)' }).click();
  await expect(row.getByRole('textbox')).toHaveValue('800');
  expect((await lamp(page)).candela).toBe(bulb.candela);

  await row.getByRole('textbox').fill('400');
  await row.getByRole('textbox').press('Enter');
  expect((await lamp(page)).candela).toBeCloseTo(400 / (4 * Math.PI), 3);

  const bar = inspector.locator('[data-field="kelvin"] .slider');
  const { width, height } = (await bar.boundingBox())!;
  await bar.click({ position: { x: width * 0.9, y: height / 2 } });
  const cold = await lamp(page);
  expect(cold.kelvin).toBeGreaterThan(6000);
  expect(cold.blue).toBeGreaterThan(0.9);

  expect((await history(page)).slice(steps)).toHaveLength(4);
  for (let i = 0; i < 4; i++) await page.keyboard.press('ControlOrMeta+z');
  expect(await lamp(page)).toEqual(before);
});

test('automatic exposure keeps a surface as bright under a light 64 times as strong, within its limits @verify', async ({
  page,
}) => {
  await addObject(page, 'Mesh', 'Plane');
  const green = async (intensity: number, values: Record<string, string | number>): Promise<number> => {
    await page.evaluate(
      ([strength, settings]) => {
        const { scene } = window.editor.document;
        for (const light of scene.componentsOf<Light>('Light')) light.intensity = strength;
        scene.settings.backgroundColour = [strength / 4, strength / 4, strength / 4];
        for (const [name, value] of Object.entries(settings)) scene.settings.set(name, value);
      },
      [intensity, values] as const,
    );
    await page.evaluate(() => window.editor.viewport.picture.ready);
    return (await pixelAt(page, 0.5, 0.55))[1];
  };
  const dim = await green(1, { exposureBy: 'automatic', toneMapping: 'linear' });
  expect(dim).toBeGreaterThan(30);
  expect(dim).toBeLessThan(230);
  expect(Math.abs((await green(64, {})) - dim)).toBeLessThan(6);
  // the limit of a bright day: a picture in dim light stays dark
  expect(await green(1, { exposureLeast: 6 })).toBeLessThan(dim / 3);
  expect(await green(64, { exposureBy: 'factor' })).toBe(255);
});

test('sun and moon are added, go down with the day’s slider, and to Sydney by a click on the map; a step each @verify', async ({
  page,
}) => {
  await addObject(page, 'Light', 'Sun and moon');
  const sun = (): Promise<{ elevation: number; intensity: number; latitude: number }> =>
    page.evaluate(() => {
      const [each] = window.editor.document.selectedObjects;
      const day = each.getComponent('SunAndMoon') as SunAndMoon;
      const { intensity } = (each.getComponent('Light') as Light).three;
      return { elevation: day.sun.elevation, intensity, latitude: day.latitude };
    });
  const before = await sun();
  expect(before.elevation).toBeGreaterThan(0.7);
  const steps = (await history(page)).length;
  const inspector = page.getByRole('region', { name: 'Inspector' });
  const bar = inspector.locator('[data-field="hour"] .slider');
  const { width, height } = (await bar.boundingBox())!;
  await bar.click({ position: { x: width - 1, y: height / 2 } });
  const night = await sun();
  expect(night.elevation).toBeLessThan(-0.2);
  expect(night.intensity).toBeLessThan(0.3);

  const map = inspector.getByRole('application', { name: /Map of the world/ });
  await map.scrollIntoViewIfNeeded();
  const box = (await map.boundingBox())!;
  await map.click({ position: { x: (box.width * (151 + 180)) / 360, y: (box.height * (90 + 34)) / 180 } });
  expect((await sun()).latitude).toBeCloseTo((-34 * Math.PI) / 180, 1);
  expect(await history(page)).toHaveLength(steps + 2);
  for (let i = 0; i < 2; i++) await page.keyboard.press('ControlOrMeta+z');
  expect(await sun()).toEqual(before);
});

test('the light meter reads lux in the light and in the shadow, and false colours show both @verify', async ({
  page,
}) => {
  await addObject(page, 'Mesh', 'Plane');
  await addObject(page, 'Mesh', 'Box');
  const places = await page.evaluate(() => {
    const { viewport, document } = window.editor;
    const { scene, selection } = document;
    for (const light of scene.componentsOf<Light>('Light')) {
      light.enabled = light.type === 'directional';
      Object.assign(light, { intensity: 300, castShadow: true });
      light.gameObject.transform.set('rotation', [-Math.PI / 2, 0, 0]);
    }
    const { position } = scene.find('Plane')!.object3D;
    const board = scene.find('Box')!.transform;
    board.set('position', [position.x, position.y + 1, position.z]);
    board.set('scale', [1, 0.05, 1]);
    selection.set([]);
    viewport.renderNow();
    const { width, height } = viewport.canvas.getBoundingClientRect();
    return [-0.9, 0].map((x) => {
      const { x: u, y: v } = position
        .clone()
        .set(position.x + x, position.y, position.z)
        .project(viewport.camera as never);
      return { x: ((u + 1) / 2) * width, y: ((1 - v) / 2) * height };
    });
  });
  const palette = async (name: string): Promise<void> => {
    await page.keyboard.press('ControlOrMeta+k');
    await page.getByRole('combobox', { name: 'Search commands' }).fill(name);
    await page.keyboard.press('Enter');
  };
  await palette('Light meter');
  const meter = page.getByRole('region', { name: 'Light meter' });
  const canvas = page.locator('.viewport-place canvas');
  await canvas.click({ position: places[0] });
  await expect(meter.getByRole('status')).toContainText(/(299|300|301) lx.*6\.9 EV/);
  await canvas.click({ position: places[1] });
  await expect(meter.getByRole('status')).toContainText(/^Illuminance0 lx/);
  await meter.getByRole('button', { name: 'Close' }).click();
  await palette('False colours');
  await expect(page.getByRole('figure', { name: /Scale: from 0.1 lux/ })).toBeVisible();
  const { width, height } = (await canvas.boundingBox())!;
  const colours = (): Promise<number[][]> =>
    Promise.all(places.map(({ x, y }) => pixelAt(page, x / width, y / height)));
  // 300 lx are between green and yellow, nothing is black
  await expect
    .poll(async () => (await colours()).map(([r, g]) => [r > 100, g > 100]))
    .toEqual([
      [true, true],
      [false, false],
    ]);
});

test('an exported page has the sky of the hour in nits, by an automatic exposure @verify', async ({
  page,
  context,
}, info) => {
  await addObject(page, 'Light', 'Sun and moon');
  await page.evaluate(() => {
    const { scene, selectedObjects } = window.editor.document;
    selectedObjects[0].getComponent('SunAndMoon')!.set('brightness', 'measured');
    scene.settings.exposureBy = 'automatic';
    scene.activeCamera!.gameObject.transform.set('rotation', [0.4, 0, 0]);
  });
  await page.keyboard.press('Control+Shift+E');
  const download = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Web page…' }).click();
  const html = info.outputPath('sky.html');
  await (await download).saveAs(html);
  const other = await context.newPage();
  const problems: string[] = [];
  other.on('pageerror', (error) => problems.push(error.message));
  other.on('console', (message) => message.type() === 'error' && problems.push(message.text()));
  await other.setViewportSize({ width: 160, height: 90 });
  await other.goto(pathToFileURL(html).href);
  const bytes = await playerPicture(other);
  const [red, , blue] = [0, 1, 2].map((channel) => {
    let sum = 0;
    for (let at = channel; at < 160 * 4 * 20; at += 4) sum += bytes[at];
    return sum / (160 * 20);
  });
  expect(blue).toBeGreaterThan(red + 20);
  expect(red).toBeGreaterThan(15);
  expect(blue).toBeLessThan(235);
  expect(problems).toEqual([]);
});
