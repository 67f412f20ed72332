import type { Page } from '@playwright/test';
import { axeProblemsInVerify as axeProblems } from '../support/axeProblems';
import { addObject } from './editor';
import { expect, test } from './sharedEditor';

test.use({ viewport: { width: 840, height: 400 } });

/** The brightest channel of the picture, drawn now; from 0 to 255. */
const brightest = (page: Page): Promise<number> =>
  page.evaluate(() => {
    const { viewport } = window.editor;
    const gl = viewport.webgl.getContext() as WebGL2RenderingContext;
    viewport.renderNow();
    const [width, height] = [gl.drawingBufferWidth, gl.drawingBufferHeight];
    const pixels = new Uint8Array(width * height * 4);
    gl.readPixels(0, 0, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    let most = 0;
    for (let i = 0; i < pixels.length; i++) if (i % 4 < 3) most = Math.max(most, pixels[i]);
    return most;
  });

test('the frame: technique and why, passes, two techniques side by side, all views', async ({ page }) => {
  await addObject(page, 'Mesh', 'Sphere');
  await page.keyboard.press('f');
  await page.getByRole('tab', { name: 'Frame' }).click();
  const frame = page.getByRole('region', { name: 'Frame', exact: true });
  await expect(frame.getByLabel('Why this technique')).toContainText('Forward, single pass: few lights');
  await expect(frame.getByRole('row', { name: /^opaque/ })).toBeVisible();

  // effects that a plugin brings and takes while the panel is open
  const haze = frame.getByText('Haze', { exact: true });
  await expect(frame.getByRole('combobox', { name: 'Anti-aliasing' })).toBeVisible();
  await expect(haze).toHaveCount(0);
  const added = await page.evaluateHandle(() => {
    const make = (): never => {
      throw new Error('Nothing chose the effect.');
    };
    return { end: window.editor.viewport.addedEffects.add({ id: 'haze', label: 'Haze', help: 'For a test.', make }) };
  });
  await expect(haze).toBeVisible();
  await added.evaluate(({ end }) => end());
  await expect(haze).toHaveCount(0);

  // another technique, live
  await frame.getByRole('combobox', { name: 'Technique of the frame' }).click();
  await page.getByRole('option', { name: /^Deferred shading/ }).click();
  await expect(frame.getByRole('row', { name: /^g-buffer/ })).toBeVisible();
  await expect(frame.getByLabel('Why this technique')).toHaveCount(0);

  // edges: the forward technique left them to the canvas
  await expect(frame.getByRole('row', { name: /^SMAA/ }).first()).toBeVisible();
  await expect(frame.getByRole('table', { name: 'What the effects cost' })).toContainText(/SMAA\s*\d+\.\d/);
  await frame.getByRole('combobox', { name: 'Anti-aliasing' }).click();
  await page.getByRole('option', { name: /^Of the technique/ }).click();
  await expect(frame.getByRole('row', { name: /^SMAA/ })).toHaveCount(0);

  // side by side
  await frame.getByRole('checkbox', { name: 'Compare two techniques' }).click();
  const handle = page.getByRole('slider', { name: 'Where the two techniques meet' });
  await expect(handle).toContainText('Deferred shading');
  await expect(handle).toContainText('Forward, single pass');
  const psnr = frame.getByLabel('Difference of the two').getByText(/dB$/);
  await expect(psnr).toBeVisible();
  expect(parseFloat((await psnr.textContent())!)).toBeGreaterThan(45);
  expect(await brightest(page)).toBeGreaterThan(100);
  await handle.focus();
  await page.keyboard.press('ArrowLeft');
  await expect(handle).toHaveAttribute('aria-valuenow', '48');
  await page.keyboard.press('End');
  await expect(handle).toHaveAttribute('aria-valuenow', '100');
  expect(await axeProblems(page)).toEqual([]);

  // their difference: next to nothing, until it is made much larger
  await frame.getByRole('checkbox', { name: 'Show the difference' }).click();
  await expect(handle).toHaveCount(0);
  const faint = await brightest(page);
  expect(faint).toBeLessThan(32);
  await frame.getByRole('textbox', { name: 'Difference made larger by' }).fill('1000');
  await page.keyboard.press('Enter');
  await expect.poll(() => brightest(page)).toBeGreaterThan(faint);
  await frame.getByRole('checkbox', { name: 'Compare two techniques' }).click();
  expect(await brightest(page)).toBeGreaterThan(100);

  // all views at once; one of them alone; the scale of those that count
  await frame.getByRole('checkbox', { name: 'All views at once' }).click();
  const names = page.locator('.view-names button');
  await expect(names).toHaveCount(11);
  expect(await axeProblems(page)).toEqual([]);
  await names.filter({ hasText: 'Light count' }).click();
  await expect(names).toHaveCount(0);
  expect(await page.evaluate(() => window.editor.viewport.view)).toBe('light-count');
  const scale = page.getByRole('figure', { name: /^Scale/ });
  await expect(scale).toContainText('32+');
  await frame.getByRole('textbox', { name: 'Heat map maximum' }).fill('8');
  await page.keyboard.press('Enter');
  await expect(scale).toContainText('8+');
});
