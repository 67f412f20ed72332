import { compareImages, isFlat } from '../support/images';
import { still } from '../support/viewer';
import { expect, test } from './driven';

test('viewer: a scene by three techniques, as stock three', async ({ driven, found }) => {
  const noise: number[] = [];
  for (const technique of ['auto', 'deferred', 'clustered-forward']) {
    const query = new URLSearchParams(Object.entries({ ...still, technique }).map(([key, value]) => [key, `${value}`]));
    await driven.open(`${process.env.FAROL_VIEWER_URL}?${query}`);
    await driven.until(() => 'viewer' in window);
    await driven.evaluate(() => window.viewer.ready);
    const [stock, drawn] = await driven.evaluate(() => {
      const { viewer } = window;
      return [viewer.readStockPixels(), viewer.readPixels()].map((each) => ({ ...each, data: [...each.data] }));
    });
    expect(isFlat(stock), technique).toBe(false);
    noise.push(compareImages(stock, drawn).psnr);
  }
  found(`${Math.min(...noise).toFixed(1)} dB`);
  expect(Math.min(...noise)).toBeGreaterThan(60);
});

test('Lab: a comparison measured', async ({ driven, found }) => {
  const plan =
    '#preset=custom&series=benchmarkLights:lights:4,9:n=1&size=96x54&techniques=forward,deferred&rounds=2&turn=30&longest=60000';
  await driven.open(`${process.env.FAROL_LAB_URL}${plan}`);
  await driven.click('button', 'Measure: your own comparison');
  // by a key: charts that arrive move the line
  const table = 'Table of 4 rows, with warnings and what failed';
  await driven.until((text) => {
    const line = [...document.querySelectorAll('summary')].find((each) => each.textContent.trim() === text);
    line?.focus();
    return line;
  }, table);
  await driven.press('Enter');
  const rows = (): Promise<string[]> =>
    driven.evaluate(() => {
      const all = [...document.querySelectorAll('.results table tr')].map((row) => row.textContent);
      return all.filter((text) => /Farol: (forward|deferred).*\d \(/.test(text));
    });
  await expect.poll(rows).toHaveLength(4);
  found('4 rows');
});
