import type { Light, SunAndMoon } from '@farol/engine';
import type { Page } from '@playwright/test';
import { addObject, history } from './editor';
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
  expect(bulb).toMatchObject({ type: 'point', unit: 'watt', kelvin: 2790 });
  expect(bulb.candela).toBeCloseTo(870 / (4 * Math.PI), 2);
  expect(bulb.blue).toBeLessThan(0.15);

  await row.getByRole('button', { name: 'W Incandescent' }).click();
  await page.getByRole('menuitemcheckbox', { name: 'Lumen (lm)' }).click();
  await expect(row.getByRole('textbox')).toHaveValue('870');
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
