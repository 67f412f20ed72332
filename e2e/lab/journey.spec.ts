import type { Page } from '@playwright/test';
import { axeProblems } from '../support/axeProblems';
import { expect, test } from '../support/test';

test.use({ reducedMotion: 'reduce' });

/** A comparison that a software rasteriser draws in seconds: one plane, 4 and 9 lights, two techniques, 96 × 54. */
const tiny =
  '#preset=custom&series=benchmarkLights:lights:4,9:n=1&size=96x54&techniques=forward,deferred&rounds=1&turn=30&longest=60000';

/** Expects the warning about a software rasteriser, unless a GPU draws. */
const expectMachine = (page: Page): Promise<void> =>
  expect(page.getByText(/software rasteriser, not on a graphics card/)).toHaveCount(process.env.FAROL_GPU ? 0 : 1);

test('builds a comparison by mouse and keyboard, and measures it', async ({ page }) => {
  await page.goto('./');
  await expect(page.getByRole('button', { name: /Measure this machine/ })).toBeEnabled();
  // reference results are there before anything is measured
  await expect(page.getByText('reference, not your machine', { exact: true })).toBeVisible();
  await expect(page.locator('.results figure svg').first()).toBeVisible();
  // the machine is named, with its warning
  await expectMachine(page);

  await page.getByText('Build your own').click();
  await page.getByRole('button', { name: 'Remove chart 2' }).click();
  await page.getByLabel('Scene').selectOption('Planes');
  const values = page.getByLabel('Values: lights');
  await values.fill('4, nine');
  await expect(page.getByText('“nine” is no whole number')).toBeVisible();
  await values.fill('4');
  await page.getByLabel('Width').fill('96');
  await page.getByLabel('Height').fill('54');
  await page.getByRole('button', { name: 'None of three.js' }).click();
  await page.getByRole('button', { name: 'None of Farol’s techniques' }).click();
  // by keyboard
  const forward = page.getByRole('checkbox', { name: 'forward', exact: true });
  await forward.focus();
  await page.keyboard.press('Space');
  await page.keyboard.press('Tab');
  await page.keyboard.press('Tab');
  await expect(page.getByRole('checkbox', { name: 'deferred', exact: true })).toBeFocused();
  await page.keyboard.press('Space');
  await page.getByLabel('Turns for each').fill('1');
  await page.getByLabel(/^A turn/).fill('30');
  await page.getByLabel(/^Leave out frames/).fill('60000');
  await page.getByRole('checkbox', { name: /what a change costs/ }).uncheck();
  await page.getByRole('checkbox', { name: /ends in time/ }).uncheck();
  await expect(page.getByText('1 case × 2 competitors')).toBeVisible();
  await expect.poll(() => new URL(page.url()).hash).toContain(tiny.replace('4,9', '4'));

  await page.getByRole('button', { name: 'Measure: your own comparison' }).focus();
  await page.keyboard.press('Enter');
  await expect(page.getByRole('heading', { name: /Measuring: Custom/ })).toBeFocused();
  const heading = page.getByRole('heading', { name: 'Custom', exact: true });
  await expect(heading).toBeFocused({ timeout: 60_000 });
  // by a key: charts that come meanwhile move it down under the pointer
  await page.getByText('Table of 2 rows').press('Enter');
  const rows = page.getByRole('table').filter({ hasText: 'Remarks' }).getByRole('row');
  await expect(rows).toHaveCount(3);
  await expect(rows.nth(1)).toContainText(/Farol: forward.*\d \(/);
  await expect(page.locator('.results figure svg').first()).toBeVisible();
  await page.getByRole('button', { name: /^Farol: deferred/ }).click();
  await expect(page.getByRole('dialog')).toContainText('Reference: ');
  await expect(page.getByRole('dialog')).not.toContainText('small pictures');
  await page.keyboard.press('Escape');
  await expect(page.getByRole('dialog')).toHaveCount(0);

  // the address holds the configuration
  await page.reload();
  await expect(page.getByText('1 case × 2 competitors')).toBeVisible();
  await page.getByText('Build your own').click();
  await expect(values).toHaveValue('4');
});

test('a run that is cancelled keeps the rows that it has @verify', async ({ page }) => {
  await page.goto(`./${tiny}`);
  await page.getByText('Build your own').click();
  // far longer than the test
  await page.getByLabel('Turns for each').fill('50');
  await page.getByLabel(/^A turn/).fill('2000');
  await page.getByRole('button', { name: 'Measure: your own comparison' }).click();
  // the row of the current turn is kept, that of a competitor being opened is not
  const now = page.locator('.running .now strong');
  await expect(now).toHaveText('Farol: deferred');
  await expect(now).toHaveText('Farol: forward');
  await page.getByRole('button', { name: /Cancel/ }).click();
  await expect(page.locator('.run-head')).toContainText('not complete');
  await page.getByText(/Table of \d rows/).click();
  const rows = page.getByRole('table').filter({ hasText: 'Remarks' }).getByRole('row');
  await expect(rows.nth(1)).toContainText('Farol: forward');
});

test('says what helps without WebGL 2, and where the frame that is measured does not open', async ({ page }) => {
  await page.route('**/stage.html', (route) => route.abort());
  await page.goto('./');
  await expect(page.getByText(/The frame that draws did not load .*: reload the page/)).toBeVisible();
  await expect(page.getByRole('button', { name: /Measure this machine/ })).toBeDisabled();

  await page.addInitScript(() => {
    HTMLCanvasElement.prototype.getContext = () => null;
  });
  await page.reload();
  await expect(page.getByRole('alert')).toContainText('WebGL 2 is switched off here: switch hardware acceleration on');
});

for (const [theme, width, tag] of [
  ['light', 1280, ' @verify'],
  ['dark', 390, ''],
] as const) {
  test.describe(`${theme}, ${width} pixels wide`, () => {
    test.use({ colorScheme: theme, viewport: { width, height: 800 } });

    test(`axe finds nothing serious, nothing is cut off${tag}`, async ({ page }) => {
      await page.goto('./' + tiny);
      await page.getByText('Build your own').click();
      await expectMachine(page);
      expect(await axeProblems(page)).toEqual([]);
      expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(width);
      await page.getByLabel('Theme').selectOption(theme === 'light' ? 'Dark' : 'Light');
      expect(await axeProblems(page, ['color-contrast'])).toEqual([]);
      // on paper: the run alone, dark on white
      await page.emulateMedia({ media: 'print' });
      await expect(page.locator('html')).toHaveCSS('color-scheme', 'light');
      await expect(page.getByRole('heading', { name: 'What to measure' })).toBeHidden();
      await expect(page.getByText('reference, not your machine', { exact: true })).toBeVisible();
    });
  });
}

test.describe('in Spanish', () => {
  test.use({ locale: 'es-ES' });
  test('the page is in the browser’s language, charts too, and in another one once it is chosen @verify', async ({
    page,
  }) => {
    await page.goto('./');
    await expect(page.locator('html')).toHaveAttribute('lang', 'es');
    await expect(page.getByRole('heading', { level: 1 })).toContainText('más rápida');
    await expect(page.getByRole('heading', { name: /^Atrio según luces puntuales/ }).first()).toBeVisible();
    await page.getByLabel('Idioma').selectOption('English');
    await expect(page.getByRole('heading', { name: /^Atrium over point lights/ }).first()).toBeVisible();
    await expect(page.locator('html')).toHaveAttribute('lang', 'en');
    await page.reload();
    await expect(page.getByLabel('Language')).toHaveValue('en');
  });
});
