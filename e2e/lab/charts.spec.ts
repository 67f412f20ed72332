import { readFile } from 'node:fs/promises';
import { expect, test } from '../support/test';
import { labRun, runFile } from './labRun';

test.use({ reducedMotion: 'reduce' });

test('a chart is read by pointer, by keyboard and as a table, and saved', async ({ page }) => {
  await page.goto('./');
  const laptop = labRun({ id: 'laptop', name: 'Laptop', device: 'Laptop GPU', factor: 1 });
  await page.getByLabel('Runs to import').setInputFiles(runFile('laptop.json', laptop));
  const chart = page.getByRole('figure', { name: /^Atrium over point lights/ });
  await expect(page.getByRole('button', { name: 'GPU', exact: true })).toBeDisabled();
  await expect(page.getByText('No GPU times: the device or the browser has no timer queries.')).toBeVisible();

  // the lines of other competitors fade
  const drawing = chart.getByRole('application');
  await expect(drawing.locator('.group-1').first()).toBeVisible();
  await drawing.focus();
  await page.keyboard.press('ArrowRight');
  const spoken = drawing.locator('[aria-live]');
  await expect(spoken).toContainText('Farol: forward, 10 lights. Frame: 2 ms median, 1.8 to 2.2 ms (30 samples)');
  await page.keyboard.press('ArrowRight');
  await expect(spoken).toContainText('Farol: forward, 100 lights');
  await expect(drawing.locator('.group-1').first()).toHaveClass(/chart-faded/);
  await page.keyboard.press('ArrowDown');
  await expect(spoken).toContainText('Farol: deferred, 100 lights');
  const cursor = await drawing.locator('.chart-cursor').boundingBox();
  await page.keyboard.press('Escape');
  await expect(drawing.locator('.chart-tip')).toHaveCount(0);
  await page.mouse.move(cursor!.x + 12, cursor!.y + 12);
  await expect(drawing.locator('.chart-tip')).toContainText('Picture 51.5 dB PSNR against forward');

  await chart.getByText('Table', { exact: true }).click();
  await expect(chart.getByRole('row', { name: /^Farol: deferred/ })).toContainText('5 (4.5 to 5.5)');
  await page.getByRole('button', { name: 'forward', exact: true, pressed: true }).click();
  await expect(chart.getByRole('row', { name: /^Farol: forward/ })).toHaveCount(0);
  await page.getByRole('button', { name: 'Show all' }).click();

  const save = async (kind: 'SVG' | 'PNG') => {
    const [download] = await Promise.all([
      page.waitForEvent('download'),
      chart.getByRole('button', { name: new RegExp(`^Save ${kind}`) }).click(),
    ]);
    expect(download.suggestedFilename()).toBe(`curve-sponza-lights.${kind.toLowerCase()}`);
    return readFile(await download.path());
  };
  const svg = (await save('SVG')).toString();
  expect(svg).toContain('>Atrium over point lights');
  expect(svg).not.toContain('var(');
  const png = await save('PNG');
  // twice the 960 pixels of the file
  expect([png.subarray(1, 4).toString(), png.readUInt32BE(16)]).toEqual(['PNG', 1920]);
});
