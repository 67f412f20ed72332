import { pathToFileURL } from 'node:url';
import type { Locator, Page } from '@playwright/test';
import { addObject, history, serialized } from './editor';
import { expect, test } from './sharedEditor';

test.use({ viewport: { width: 1200, height: 800 } });

/** The colour in the middle of the picture, drawn now; each channel from 0 to 255. */
const middle = (page: Page): Promise<number[]> =>
  page.evaluate(() => {
    const { viewport } = window.editor;
    const gl = viewport.webgl.getContext() as WebGL2RenderingContext;
    viewport.renderNow();
    const pixel = new Uint8Array(4);
    gl.readPixels(gl.drawingBufferWidth >> 1, gl.drawingBufferHeight >> 1, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
    return [...pixel.slice(0, 3)];
  });

/** The text of a surface with a field `green`. */
const textOf = (body: string): string =>
  `uniform float green; // = 0 [0, 1, 0.05] Green\nvoid surface(inout SurfaceData s) {\n  ${body}\n}\n`;

const inspectorOf = (page: Page): Locator => page.getByRole('region', { name: 'Inspector' });
const panelOf = (page: Page): Locator => page.getByRole('region', { name: 'Microshaders' });

/** Types the text of the surface on show. */
async function type(page: Page, text: string): Promise<void> {
  await panelOf(page).locator('.cm-content').click();
  await page.keyboard.press('Control+a');
  await page.keyboard.insertText(text);
}

/** Makes a surface for a sphere that fills the middle of the picture, and gives it a text: green by a field, which is 0. */
async function makeTint(page: Page): Promise<void> {
  await addObject(page, 'Mesh', 'Sphere');
  await page.evaluate(() => {
    Object.assign(window.editor.viewport, { technique: 'deferred', showGrid: false, showIcons: false });
  });
  await page.keyboard.press('f');
  await page.keyboard.press('q');
  const before = await history(page);

  // one step makes the surface and the material that wears it
  await page.getByRole('menuitem', { name: 'Object', exact: true }).click();
  await page.getByRole('menuitem', { name: 'New surface' }).press('ArrowRight');
  await page.getByRole('menuitem', { name: 'Tint', exact: true }).click();
  await expect.poll(() => history(page)).toEqual([...before, 'Made surface Tint for Sphere']);

  // its text, compiled while it is typed: what it declares is a field
  await inspectorOf(page).getByRole('button', { name: 'Edit its text' }).click();
  await expect(panelOf(page).locator('.cm-content')).toContainText('void surface(inout SurfaceData s)');
  await type(page, textOf('s.color = vec3(0.0); s.emissive = vec3(0.0, green, 0.0);'));
  await expect(inspectorOf(page).getByRole('textbox', { name: 'Green', exact: true })).toHaveValue('0');
}

test('a surface from a built-in, on an object: its values are fields; its text is edited, broken and mended @verify', async ({
  page,
}) => {
  await makeTint(page);
  const [inspector, panel] = [inspectorOf(page), panelOf(page)];
  const isGreen = (): Promise<boolean> => middle(page).then(([r, g]) => g > 2 * r);
  const green = inspector.getByRole('textbox', { name: 'Green', exact: true });
  expect(await isGreen()).toBe(false);
  const box = (await inspector.locator('[data-field="surface.green"] .slider').boundingBox())!;
  await page.mouse.click(box.x + box.width - 4, box.y + box.height / 2);
  await expect(green).not.toHaveValue('0');
  await expect.poll(isGreen).toBe(true);

  // broken: the error is at its line, the picture as it was
  await type(page, textOf('s.emissive = vec3(0.0, gren, 0.0);'));
  await expect(panel.getByRole('status')).toContainText('Does not compile');
  await expect(panel.getByRole('list', { name: 'Errors' })).toContainText("Tint:3'gren' : undeclared identifier");
  await expect(panel.locator('.cm-lint-marker-error')).toHaveCount(1);
  expect(await isGreen()).toBe(true);

  // mended
  await type(page, textOf('s.color = vec3(0.0); s.emissive = vec3(0.0, 0.0, green);'));
  await expect(panel.getByRole('status')).toContainText('Of this scene');
  await expect.poll(isGreen).toBe(false);
  const { assets } = JSON.parse(await serialized(page)) as { assets: { type: string; values: object }[] };
  expect(assets.find(({ type: each }) => each === 'material')?.values).toMatchObject({
    surface: 'Tint',
    surfaceValues: expect.stringMatching(/^\{"green":/),
  });

  // steps of history, taken back
  await page.getByRole('tab', { name: 'History' }).click();
  const stepsSince = (list: readonly string[]): number =>
    list.length - 1 - list.indexOf('Made surface Tint for Sphere');
  await expect.poll(() => history(page).then(stepsSince)).toBe(3);
  await page.keyboard.press('Control+z');
  await expect.poll(isGreen).toBe(true);
});

test('a page that is exported draws the scene’s own surfaces; on a phone all of the panel is in the window @verify', async ({
  page,
  context,
}) => {
  await makeTint(page);
  await inspectorOf(page).getByRole('textbox', { name: 'Green', exact: true }).fill('1');
  await page.keyboard.press('Enter');
  await page.keyboard.press('Control+Shift+E');
  const download = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Web page…' }).click();
  const html = test.info().outputPath('surface.html');
  await (await download).saveAs(html);
  const other = await context.newPage();
  const problems: string[] = [];
  other.on('pageerror', (error) => problems.push(error.message));
  other.on('console', (message) => message.type() === 'error' && problems.push(message.text()));
  await other.setViewportSize({ width: 160, height: 120 });
  await other.goto(pathToFileURL(html).href);
  const canvas = other.locator('canvas');
  await expect(canvas).toHaveAttribute('aria-label', /./);
  const greenPixels = (): Promise<number> =>
    canvas.evaluate(
      (element: HTMLCanvasElement) =>
        new Promise<number>((resolve) => {
          requestAnimationFrame(() => {
            const copy = document.createElement('canvas');
            [copy.width, copy.height] = [element.width, element.height];
            const drawing = copy.getContext('2d', { willReadFrequently: true })!;
            drawing.drawImage(element, 0, 0);
            const { data } = drawing.getImageData(0, 0, copy.width, copy.height);
            let count = 0;
            for (let at = 0; at < data.length; at += 4) if (data[at + 1] > 60 && data[at + 1] > 2 * data[at]) count++;
            resolve(count);
          });
        }),
    );
  await expect.poll(greenPixels).toBeGreaterThan(50);
  expect(problems).toEqual([]);
  await other.close();

  // on a phone: all of the panel is in the window
  await page.getByRole('button', { name: 'Close', exact: true }).click();
  await page.setViewportSize({ width: 390, height: 844 });
  await expect(page.locator('.sheet-tabs')).toBeVisible();
  await page.evaluate(() => window.editor.openMicroShader('surface:Tint'));
  await expect(panelOf(page).getByRole('button', { name: 'Show the asset' })).toBeInViewport({ ratio: 1 });
  await expect(panelOf(page).getByRole('status')).toBeInViewport({ ratio: 1 });
});
