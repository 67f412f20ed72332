import { test as own } from '../support/test';
import type { Locator, Page } from '@playwright/test';
import { axeProblemsInVerify as axeProblems } from '../support/axeProblems';
import { addObject, fieldOf, history, openEditor, serialized } from './editor';
import { expect, test } from './sharedEditor';

const options = { viewport: { width: 1100, height: 560 }, reducedMotion: 'reduce' } as const;
test.use(options);
own.use(options);

const lantern = (page: Page): Locator => page.getByRole('region', { name: 'Lantern' });

/** Adds the plugin Lantern, whose command has a light flicker. */
async function addLantern(page: Page): Promise<void> {
  await addObject(page, 'Light', 'Point light');
  await page.keyboard.press('Control+k');
  await page.getByRole('combobox', { name: 'Search commands' }).fill('lantern');
  await page.getByRole('option', { name: /example of a plugin/ }).click();
  await page.getByRole('tab', { name: 'Lantern' }).click();
  await expect(lantern(page)).toContainText('No lamp flickers.');
  await page.keyboard.press('Control+Alt+l');
  await expect(lantern(page)).toContainText('Flickering: Point light');
}

const flickerOf = (page: Page): Locator => page.getByRole('region', { name: 'Flicker', exact: true });

/** Gives the Flicker a depth that is not its default, by its field in the inspector. */
async function setDepth(page: Page): Promise<void> {
  await page.getByRole('tab', { name: 'Inspector' }).click();
  await flickerOf(page).getByRole('slider', { name: 'Depth' }).focus();
  await page.keyboard.press('End');
  await page.keyboard.press('ArrowLeft');
  expect(await fieldOf(page, 'Point light', 'Flicker', 'depth')).toBe(0.99);
}

test('a plugin brings a panel, a component with a field of its own, a technique and a command', async ({ page }) => {
  await addLantern(page);
  expect((await history(page)).at(-1)).toBe('Added Flicker to Point light');

  // the component, with its kind of field, in the inspector and in the file
  await setDepth(page);
  const saved = await serialized(page);
  expect(saved).toContain('"depth": 0.99');
  await page.keyboard.press('Control+z');
  expect(await fieldOf(page, 'Point light', 'Flicker', 'depth')).toBe(1);
  expect(await axeProblems(page)).toEqual([]);

  // the technique draws
  await page.keyboard.press('Control+k');
  await page.getByRole('combobox', { name: 'Search commands' }).fill('vignette');
  await page.keyboard.press('Enter');
  await expect(page.getByRole('combobox', { name: 'Technique', exact: true })).toHaveText('Vignette');
  const [corner, middle] = await page.evaluate(() => {
    const { viewport } = window.editor;
    Object.assign(viewport, { showGrid: false, showIcons: false });
    window.editor.document.selection.set([]);
    const gl = viewport.webgl.getContext() as WebGL2RenderingContext;
    viewport.renderNow();
    const at = (x: number, y: number): number => {
      const pixel = new Uint8Array(4);
      gl.readPixels(x, y, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
      return pixel[0] + pixel[1] + pixel[2];
    };
    return [at(1, 1), at(gl.drawingBufferWidth >> 1, gl.drawingBufferHeight >> 1)];
  });
  expect(corner).toBeLessThan(middle * 0.6);
});

own(
  'a plugin comes again after a reload, goes with all that it brought, and is brought back by undo @verify',
  async ({ page }) => {
    await openEditor(page, 'empty');
    await addLantern(page);
    const panel = lantern(page);
    const flicker = flickerOf(page);
    // a default would not be in the file
    await setDepth(page);

    // it is there again after a reload, before the scene that needs it
    await expect.poll(() => page.evaluate(() => window.editor.autosave?.isUpToDate)).toBe(true);
    await page.reload();
    await page.getByRole('button', { name: 'Recover' }).click();
    await page.getByRole('tab', { name: 'Lantern' }).click();
    await expect(panel).toContainText('Flickering: Point light');
    const known = await page.evaluate(() => Object.keys(window.editor.viewport.farol.techniques));
    expect(known).toContain('vignette');

    // switched off, it goes with all that it brought; its component stays as data, and undo brings the plugin back
    const before = await serialized(page);
    const switchLantern = async (): Promise<void> => {
      await page.keyboard.press('Control+k');
      await page.getByRole('combobox', { name: 'Search commands' }).fill('lantern example');
      await page.keyboard.press('Enter');
    };
    await switchLantern();
    await expect(page.getByText(/The plugin Lantern is removed: 1 Flicker kept as data/)).toBeVisible();
    await expect(page.getByRole('tab', { name: 'Lantern' })).toHaveCount(0);
    expect(await serialized(page)).toBe(before);
    await page.evaluate(() => {
      const { document } = window.editor;
      document.selection.set([document.scene.find('Point light')!.id]);
    });
    await page.getByRole('tab', { name: 'Inspector' }).click();
    await expect(flicker).toContainText('Depth');
    await expect(flicker.getByRole('slider')).toHaveCount(0);
    expect(await axeProblems(page)).toEqual([]);
    expect(await page.evaluate(() => 'vignette' in window.editor.viewport.farol.techniques)).toBe(false);
    await page.keyboard.press('Control+z');
    await expect(page.getByRole('tab', { name: 'Lantern' })).toBeVisible();
    await expect(flicker.getByRole('slider', { name: 'Depth' })).toBeVisible();
    expect(await serialized(page)).toBe(before);
  },
);

own('two editors on one page each have plugins of their own, on renderers of their own @verify', async ({ page }) => {
  await openEditor(page, 'empty');
  const states = await page.evaluate(async () => {
    const first = window.editor;
    const Editor = first.constructor as new (canvas: HTMLCanvasElement, options: object) => typeof first;
    const second = new Editor(document.createElement('canvas'), { scene: 'empty', storage: 'second' });
    await second.ready;
    const bell = {
      name: 'Bell',
      actions: [{ id: 'bell.ring', label: 'Ring', run() {} }],
      techniques: { bell: { ...first.viewport.farol.techniques.deferred, label: 'Bell' } },
      microshaders: { bell: '// How loud the bell is.\n// Farol\nfloat farol_bell() {\n  return 1.0;\n}\n' },
    };
    const states: boolean[][] = [];
    const note = (): unknown =>
      states.push(
        [first, second].flatMap(({ viewport: { farol }, plugins }) => [
          plugins.list.length === 1,
          'bell' in farol.techniques,
          farol.microshaders.has('bell'),
        ]),
      );
    first.addPlugin(bell);
    first.viewport.farol.technique = 'bell' as never;
    first.viewport.renderNow();
    note();
    second.addPlugin(bell);
    note();
    first.removePlugin('Bell');
    first.viewport.renderNow();
    note();
    return { states, technique: first.viewport.technique };
  });
  const [has, lacks] = [Array<boolean>(3).fill(true), Array<boolean>(3).fill(false)];
  expect(states).toEqual({
    states: [
      [...has, ...lacks],
      [...has, ...has],
      [...lacks, ...has],
    ],
    technique: 'auto',
  });
});

test('a plugin whose names are taken is refused as a whole', async ({ page }) => {
  const message = await page.evaluate(() => {
    try {
      window.editor.addPlugin({
        name: 'Clash',
        actions: [
          { id: 'clash.new', label: 'New', run() {} },
          { id: 'edit.undo', label: 'Undo', run() {} },
        ],
      });
      return '';
    } catch (error) {
      return (error as Error).message;
    }
  });
  expect(message).toContain("the action 'edit.undo'");
  await page.keyboard.press('Control+k');
  await page.getByRole('combobox', { name: 'Search commands' }).fill('clash.new');
  await expect(page.getByText('Nothing matches the search.')).toBeVisible();
});
