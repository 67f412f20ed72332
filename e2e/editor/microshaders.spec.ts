import type { Locator, Page } from '@playwright/test';
import { readFile } from 'node:fs/promises';
import { axeProblemsInVerify as axeProblems } from '../support/axeProblems';
import { test as own } from '../support/test';
import { addObject, history, openEditor, serialized } from './editor';
import { expect, test } from './sharedEditor';

const options = { viewport: { width: 1200, height: 640 }, reducedMotion: 'reduce' } as const;
test.use(options);
own.use(options);

const panel = (page: Page): Locator => page.getByRole('region', { name: 'Microshaders' });

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

const isRed = (page: Page): Promise<boolean> => middle(page).then(([r, g]) => r > 2 * g);

/** Whether something in the small picture of the scene's camera is red. */
const isPreviewRed = (page: Page): Promise<boolean> =>
  page.evaluate(() => {
    const { viewport, document } = window.editor;
    const { selection, scene } = document;
    const before = selection.ids;
    selection.set([scene.find('Camera')!.id]);
    viewport.renderNow();
    selection.set(before);
    const gl = viewport.webgl.getContext() as WebGL2RenderingContext;
    // within the right lower corner, less than its smallest size
    const [width, height] = [150, 80];
    const pixels = new Uint8Array(width * height * 4);
    gl.readPixels(gl.drawingBufferWidth - width - 14, 14, width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
    return pixels.some((red, i) => i % 4 === 0 && red > 60 && red > 3 * pixels[i + 1]);
  });

/** Puts the cursor before the line of a chunk that begins with a text. */
async function goBefore(page: Page, chunk: string, beginning: string): Promise<void> {
  await page.evaluate(
    ([name, start]) => {
      const lines = window.editor.microShaders.textOf(name).split('\n');
      window.editor.openMicroShader(name, 1 + lines.findIndex((line) => line.trim().startsWith(start)));
    },
    [chunk, beginning] as const,
  );
  await expect(panel(page).locator('.cm-editor')).toHaveClass(/cm-focused/);
}

/** A sphere in the middle of the picture, lit by one white light, without helpers. */
async function openSphere(page: Page): Promise<void> {
  await addObject(page, 'Mesh', 'Sphere');
  await page.evaluate(() => {
    const { document, viewport } = window.editor;
    for (const name of ['Sky']) document.scene.find(name)!.active = false;
    Object.assign(viewport, { technique: 'forward-single-pass', showGrid: false, showIcons: false });
  });
  await page.keyboard.press('f');
  await page.keyboard.press('Escape');
  await page.getByRole('tab', { name: 'Microshaders' }).click();
  await expect(panel(page).locator('.cm-content')).toBeVisible();
}

test('edit a microshader, break it, mend it: the picture follows, keeps the last good one, and ends with the scene', async ({
  page,
}) => {
  await openSphere(page);
  await expect.poll(() => isRed(page)).toBe(false);
  expect(await isPreviewRed(page)).toBe(false);
  const before = await history(page);

  // compiled while it is typed
  await goBefore(page, 'incidentLight', 'light.attenuation = 1.0');
  await page.keyboard.type('light.color *= vec3(1.0, 0.0, 0.0);\n');
  await expect.poll(() => isRed(page)).toBe(true);
  await expect(panel(page).getByRole('status')).toContainText('Edited in this scene');
  expect(await isPreviewRed(page)).toBe(true);

  // broken: the error is at its line, the picture as it was
  await goBefore(page, 'incidentLight', 'light.color *=');
  await page.keyboard.type('light.color = nothing;\n');
  await expect(panel(page).getByRole('status')).toContainText('Does not compile');
  const line = await page.evaluate(
    () => 1 + window.editor.microShaders.textOf('incidentLight').split('\n').indexOf('light.color = nothing;'),
  );
  await expect(panel(page).getByRole('list', { name: 'Errors' })).toContainText(`incidentLight:${line}`);
  await expect(panel(page).locator('.cm-lint-marker-error')).toHaveCount(1);
  expect(await isRed(page)).toBe(true);

  // mended
  await goBefore(page, 'incidentLight', 'light.color = nothing');
  await page.keyboard.press('Control+Shift+k');
  await expect(panel(page).getByRole('status')).toContainText('Edited in this scene');
  await expect(panel(page).locator('.cm-lint-marker-error')).toHaveCount(0);
  expect(await isRed(page)).toBe(true);

  // one step of history, saved with the scene
  await page.getByRole('tab', { name: 'History' }).click();
  await expect.poll(() => history(page)).toEqual([...before, 'Edited microshader incidentLight']);
  const saved = await serialized(page);
  expect(JSON.parse(saved).microShaders.incidentLight).toContain('vec3(1.0, 0.0, 0.0)');
  await page.keyboard.press('Control+z');
  await expect.poll(() => isRed(page)).toBe(false);
  await expect(panel(page).getByRole('status')).toContainText('As built in');
  await expect(panel(page).locator('.cm-content')).not.toContainText('vec3(1.0, 0.0, 0.0)');
  await page.keyboard.press('Control+y');
  await expect.poll(() => isRed(page)).toBe(true);

  await expect(panel(page).getByRole('complementary')).toContainText('Clustered forward');

  // one that a technique brings, and nothing draws with, is tried by that technique
  await goBefore(page, 'lightLoopOne', '#include');
  await page.keyboard.type('// tried\n');
  await expect(panel(page).getByRole('status')).toContainText('Edited in this scene');

  // in another scene the built-in texts are back
  const other = JSON.stringify({ ...JSON.parse(saved), microShaders: {} });
  await page.evaluate((text) => {
    window.editor.commands.clear();
    return window.editor.openFileBytes(text, { name: null, handle: null });
  }, other);
  expect(await isRed(page)).toBe(false);
  for (const name of ['lightLoopOne', 'incidentLight']) {
    await page.evaluate((name) => window.editor.openMicroShader(name), name);
    await expect(panel(page).getByRole('status')).toContainText('As built in');
  }
});

own(
  'a microshader that nothing on the device draws with is compiled as the techniques would @verify',
  async ({ page }) => {
    await openEditor(page, 'empty');
    await page.getByRole('tab', { name: 'Microshaders' }).click();
    await expect(panel(page).locator('.cm-content')).toBeVisible();
    // that of a plugin too
    await page.evaluate(() => {
      const technique = { ...window.editor.viewport.farol.techniques['tiled-forward'], label: 'Of a plugin' };
      window.editor.addPlugin({ name: 'Own', techniques: { own: technique } });
    });
    await goBefore(page, 'tileMask', '#include');
    await expect(panel(page).getByRole('complementary')).toContainText('Of a plugin');
    await page.keyboard.type('float wrong = nowhere;\n');
    await expect(panel(page).getByRole('list', { name: 'Errors' })).toContainText('nowhere');
    await expect(panel(page).getByRole('complementary')).toContainText('None at present');
    expect(await axeProblems(page)).toEqual([]);
    await panel(page).getByRole('button', { name: 'Last good text' }).click();
    await page.getByRole('tab', { name: 'Console' }).click();
    await expect(page.getByRole('region', { name: 'Console' })).toContainText("'nowhere' : undeclared identifier");
  },
);

test('a new chunk, and XML: into the scene and out of it @verify', async ({ page }, info) => {
  await openSphere(page);
  await panel(page).getByRole('button', { name: 'New microshader' }).click();
  await page.getByRole('textbox', { name: 'Name of the microshader' }).fill('own/tint');
  await page.keyboard.press('Enter');
  await expect(panel(page).getByRole('option', { name: 'own/tint' })).toHaveAttribute('aria-selected', 'true');
  await goBefore(page, 'own/tint', '//');
  await page.keyboard.press('Control+End');
  await page.keyboard.type('vec3 own_tint() { return vec3(1.0, 0.0, 0.0); }');

  // the thesis's chunks come in as one step
  await panel(page).getByRole('button', { name: 'Import and export' }).click();
  await page.getByRole('menuitem', { name: 'Import the Phong lights of 2015' }).click();
  await expect.poll(() => history(page).then((steps) => steps.at(-1))).toBe('Imported thesis.xml');
  const chunks = Object.keys(JSON.parse(await serialized(page)).microShaders);
  expect(chunks).toContain('own/tint');
  expect(chunks.length).toBeGreaterThan(10);

  const download = page.waitForEvent('download');
  await panel(page).getByRole('button', { name: 'Import and export' }).click();
  await page.getByRole('menuitem', { name: /^Export XML/ }).click();
  const file = info.outputPath('microshaders.xml');
  await (await download).saveAs(file);
  const xml = await readFile(file, 'utf8');
  expect(xml.match(/<microshader /g)).toHaveLength(chunks.length);
  expect(xml).toContain('vec3 own_tint()');

  // deleted, and back
  await page.evaluate(() => window.editor.openMicroShader('own/tint'));
  await panel(page).getByRole('button', { name: 'Delete' }).click();
  await expect(panel(page).getByRole('option', { name: 'own/tint' })).toHaveCount(0);
  await panel(page).getByRole('listbox').focus();
  await page.keyboard.press('Control+z');
  await expect(panel(page).getByRole('option', { name: 'own/tint' })).toBeVisible();
});

test('a set of microshaders comes in as a whole or not at all, and asks before it replaces what is there @verify', async ({
  page,
}) => {
  await page.getByRole('tab', { name: 'Microshaders' }).click();
  await expect(panel(page).locator('.cm-content')).toBeVisible();
  const before = await serialized(page);
  const steps = await history(page);
  const importXML = async (name: string, chunks: string): Promise<void> => {
    await panel(page).getByRole('button', { name: 'Import and export' }).click();
    const chooser = page.waitForEvent('filechooser');
    await page.getByRole('menuitem', { name: 'Import XML…' }).click();
    const xml = `<microshaders>${chunks}</microshaders>`;
    await (await chooser).setFiles({ name, mimeType: 'text/xml', buffer: Buffer.from(xml) });
  };
  const chunk = (name: string, header: string): string =>
    `<microshader name="${name}" stage="fragment"><header><![CDATA[${header}]]></header></microshader>`;
  const tint = chunk('own/tint', 'vec3 own_tint() { return vec3(1.0, 0.0, 0.0); }');

  // one of them is broken where a technique other than the one on show draws with it
  const octahedral = await page.evaluate(() => window.editor.microShaders.textOf('octahedralNormal'));
  expect(octahedral).toContain('farol_encodeNormal');
  await importXML(
    'broken.xml',
    tint + chunk('octahedralNormal', 'vec2 farol_encodeNormal(vec3 n) { return missing; }'),
  );
  const refusal = page.getByText('broken.xml is not imported, and nothing has changed: octahedralNormal, line');
  await expect(refusal).toContainText('missing');
  expect(await serialized(page)).toBe(before);
  expect(await history(page)).toEqual(steps);

  // sound, and in the place of a built-in one
  const sound = chunk('octahedralNormal', octahedral.replaceAll(/^\/\/.*$/gm, ''));
  await importXML('sound.xml', tint + sound);
  const dialog = page.getByRole('dialog', { name: 'sound.xml replaces microshaders that are there' });
  await expect(dialog.getByRole('list', { name: 'Microshaders' })).toHaveText('octahedralNormal built in');
  await dialog.getByRole('button', { name: 'Cancel' }).click();
  expect(await serialized(page)).toBe(before);
  await importXML('sound.xml', tint + sound);
  await dialog.getByRole('button', { name: 'Replace them' }).click();
  await expect.poll(() => history(page)).toEqual([...steps, 'Imported sound.xml']);
  expect(Object.keys(JSON.parse(await serialized(page)).microShaders)).toEqual(['octahedralNormal', 'own/tint']);
});
