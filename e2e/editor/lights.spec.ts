import type { Page } from '@playwright/test';
import { expect, test as it } from '../support/test';
import { axeProblems } from '../support/axeProblems';
import { outOfReach } from '../support/outOfReach';
import { inspectorFollows, openEditor } from './editor';
import { test } from './sharedEditor';
import { type Work, workMeter } from './workMeter';

// wide enough for all columns
test.use({ viewport: { width: 1440, height: 900 } });

/** Opens the editor with the empty scene, in a window of its own. */
async function openLarge(page: Page): Promise<void> {
  await page.setViewportSize({ width: 1440, height: 900 });
  await page.emulateMedia({ reducedMotion: 'reduce' });
  await openEditor(page, 'empty');
}

/** Opens the panel and gives it most of the window's height. */
async function openLights(page: Page): Promise<void> {
  await page.getByRole('tab', { name: 'Lights' }).click();
  await expect(page.getByRole('treegrid', { name: 'Lights' })).toBeVisible();
}

const history = (page: Page): Promise<readonly string[]> => page.evaluate(() => window.editor.commands.history);

/** Intensities of the three lights of these names, and whether they are drawn. */
const shining = (page: Page, names: readonly string[]): Promise<(readonly [number, boolean])[]> =>
  page.evaluate(
    (all) =>
      all.map((name) => {
        const light = window.editor.document.scene.find(name)!.getComponent('Light') as unknown as {
          three: { intensity: number; visible: boolean };
        };
        return [light.three.intensity, light.three.visible] as const;
      }),
    names,
  );

/** A Light, as far as a test asks for what it gives three to draw. */
interface LightOfThree {
  readonly three: { readonly intensity: number };
}

const intensityOf = (page: Page, id: string): Promise<number> =>
  page.evaluate((object) => {
    const light = window.editor.document.scene.find(object)!.getComponent('Light') as unknown as LightOfThree;
    return light.three.intensity;
  }, id);

/** A scene file of 10,000 lamps far below the camera, of which the first 1,000 are in a group. */
function manyLamps(): string {
  const object = (id: string, name: string, components: object[]) => ({ id, name, parent: null, components });
  const lamps = Array.from({ length: 10_000 }, (_, i) =>
    object(`lamp${i}`, `Lamp ${i + 1}`, [
      { type: 'Transform', version: 1, id: `t${i}`, values: { position: [i % 100, -500, Math.floor(i / 100)] } },
      { type: 'Light', version: 1, id: `l${i}`, values: { intensity: 4, group: i < 1000 ? 'desk' : null } },
    ]),
  );
  const desk = object('desk', 'Street', [
    { type: 'Transform', version: 1, id: 'tDesk', values: {} },
    { type: 'LightGroup', version: 1, id: 'gDesk', values: {} },
  ]);
  const file = { format: 'farol-scene', version: 1, name: 'Street', settings: {}, activeCamera: null, assets: [] };
  return JSON.stringify({ ...file, objects: [desk, ...lamps] });
}

/** Steps of something that is done in the panel, and the frames that were drawn meanwhile. */
interface Done {
  readonly steps: number;
  readonly frames: number;
}

/** Measures from its call to the call of the function that it gives. */
type Meter<Figure> = () => Promise<(done: Done) => Promise<Figure>>;

/** Milliseconds of script a frame that the page's own thread has run: what others on the machine do does not count. */
async function scriptMeter(page: Page): Promise<Meter<number>> {
  const session = await page.context().newCDPSession(page);
  await session.send('Performance.enable', { timeDomain: 'threadTicks' });
  const script = async (): Promise<number> => {
    const { metrics } = await session.send('Performance.getMetrics');
    return 1000 * metrics.find(({ name }) => name === 'ScriptDuration')!.value;
  };
  return async () => {
    const before = await script();
    return async ({ steps, frames }) => ((await script()) - before) / Math.max(steps, frames);
  };
}

/** Work of a step, on average. */
async function stepMeter(page: Page): Promise<Meter<Work>> {
  const meter = await workMeter(page);
  return async () => {
    const end = await meter();
    return async ({ steps }) => {
      const work = Object.entries(await end()).map(([name, all]) => [name, (all as number) / steps]);
      return Object.fromEntries(work) as Work;
    };
  };
}

/**
 * Scrolls through 10,000 lights, dims a group of 1,000 and 1,000 selected rows, and finds three lights by their name.
 *
 * @returns figures of the meter by what was done
 */
async function useManyLights<Figure>(
  page: Page,
  makeMeter: (page: Page) => Promise<Meter<Figure>>,
): Promise<Record<'scroll' | 'dim group' | 'dim rows' | 'filter', Figure>> {
  await openLarge(page);
  await page.waitForFunction(() => window.editor.autosave !== null);
  await page.evaluate((text) => window.editor.openFileBytes(text, { name: null, handle: null }), manyLamps());
  await openLights(page);
  const grid = page.getByRole('treegrid', { name: 'Lights' });
  await expect(grid).toHaveAttribute('aria-rowcount', '10003');
  const meter = await makeMeter(page);
  const figures = {} as Record<string, Figure>;
  const drawn = (): Promise<number> => page.evaluate(() => window.editor.viewport.statistics.frames);
  /**
   * Does something in steps, each of which ends when what it is for is there; Playwright's own assertions are left to the
   * end, as their script would be measured. A step may be drawn as several frames. @returns frames drawn
   */
  const measure = async (what: string, steps: number, act: (step: number) => Promise<unknown>): Promise<number> => {
    // drafts are read while the page is idle, and would be measured too
    await page.waitForFunction(() => window.editor.autosave!.isUpToDate);
    const first = await drawn();
    const end = await meter();
    for (let step = 1; step <= steps; step++) await act(step);
    const frames = (await drawn()) - first;
    figures[what] = await end({ steps, frames });
    return frames;
  };
  /** Waits until an element of the page is there. */
  const seen = (selector: string) =>
    page.waitForFunction((each) => document.querySelector(each) !== null, `.lights-grid${selector}`);
  await grid.hover();
  const scrolled = await measure('scroll', 20, async (step) => {
    await page.mouse.wheel(0, 520);
    await seen(` [aria-rowindex="${step * 20 + 4}"]`);
  });
  await expect(grid.locator('[aria-rowindex="404"]')).toBeInViewport();
  expect(await grid.getByRole('row').count()).toBeLessThan(60);
  await page.mouse.wheel(0, -20 * 520);
  await expect(grid.locator('[aria-rowindex="2"]')).toBeInViewport();
  /** Dims by the slider of a row, seen at one of the lights that are dimmed with it. */
  const dim = async (what: string, row: number): Promise<void> => {
    const slider = grid.locator(`[aria-rowindex="${row}"] .slider`);
    const box = (await slider.boundingBox())!;
    const toPart = (part: number) => page.mouse.move(box.x + (box.width - 1) * part, box.y + box.height / 2);
    await toPart(1);
    await page.mouse.down();
    const full = await intensityOf(page, 'lamp999');
    await measure(what, 20, async (step) => {
      await toPart(1 - step / 25);
      await page.waitForFunction(
        (most) => {
          const light = window.editor.document.scene.find('lamp999')!.getComponent('Light') as unknown as LightOfThree;
          return light.three.intensity < most;
        },
        full * (1 - (step - 0.5) / 25),
      );
    });
    await page.mouse.up();
  };
  await dim('dim group', 2);
  expect(await history(page)).toEqual([expect.stringMatching(/^Set dimmer of Street/)]);
  await page.evaluate(() => window.editor.document.selection.set(Array.from({ length: 1000 }, (_, i) => `lamp${i}`)));
  await inspectorFollows(page);
  await dim('dim rows', 4);
  expect(await history(page)).toHaveLength(2);
  const search = page.getByRole('searchbox', { name: 'Search lights' });
  await search.focus();
  const filtered = await measure('filter', 4, async (step) => {
    await page.keyboard.press('1');
    await seen(`[aria-rowcount="${[3443, 283, 22, 3][step - 1]}"]`);
  });
  expect({ scrolled, filtered }, 'frames of a scene in which nothing changes').toEqual({ scrolled: 0, filtered: 0 });
  return figures;
}

it('10,000 lights scroll, are found, and 1,000 of them are dimmed, by the work of what is shown and what is dimmed @verify', async ({
  page,
}) => {
  const work = await useManyLights(page, stepMeter);
  console.log(`10,000 lights, work of a step: ${JSON.stringify(work)}`);
  const { scroll, filter, 'dim group': group, 'dim rows': rows } = work;
  for (const [name, { ownerSignal }] of Object.entries(work)) expect(ownerSignal, name).toBeLessThan(10);
  // 20 rows come into view at a scroll; fields are read of the rows that are shown, again for each of some renderings
  expect(scroll.elements).toBeLessThan(20 * 27);
  for (const { getAuthored } of [scroll, filter]) expect(getAuthored).toBeLessThan(5000);
  expect(filter.elements).toBeLessThan(30 * 27);
  // a group's lights follow it without edits of theirs
  expect(group).toMatchObject({ set: 1, edited: 1, elements: 0 });
  expect(group.getAuthored).toBeLessThan(3 * 1000);
  // each selected row is an edit, which every panel that shows the selection follows once
  expect(rows).toMatchObject({ set: 1000, edited: 1000, elements: 0 });
  expect(rows.getAuthored).toBeLessThan(33 * 1000);
});

it('10,000 lights scroll, are found, and 1,000 of them are dimmed, by 16 ms of script a frame @long', async ({
  page,
}) => {
  const figures = await useManyLights(page, scriptMeter);
  console.log(`10,000 lights, script of a frame (ms): ${JSON.stringify(figures)}`);
  // from source, React is its development build
  if (process.env.FAROL_E2E !== 'built') return;
  const { 'dim rows': rows, ...asked } = figures;
  // 1,000 edits a frame
  expect(rows).toBeGreaterThan(0);
  for (const figure of Object.values(asked)) expect(figure).toBeLessThan(16);
});

test('lamps are grouped, dimmed by their master and shown alone; each edit is one step, and solo is none', async ({
  page,
}) => {
  await page.evaluate(async () => {
    const { scene } = window.editor.document;
    const { constructor: GameObject } = scene.roots[0] as unknown as {
      constructor: new (name: string) => (typeof scene.roots)[0];
    };
    for (const name of ['Lamp 1', 'Lamp 2', 'Lamp 3']) {
      const lamp = new GameObject(name);
      scene.add(lamp);
      lamp.addComponent('Light', { intensity: 4 });
    }
  });
  await openLights(page);
  const grid = page.getByRole('treegrid', { name: 'Lights' });
  await page.getByRole('searchbox', { name: 'Search lights' }).fill('lamp');
  await expect(grid.getByRole('row')).toHaveCount(4);
  await grid.getByRole('row', { name: 'Lamp 1' }).getByText('Lamp 1').click();
  await page.keyboard.press('Shift+ArrowDown');
  await page.getByRole('button', { name: 'Group', exact: true }).click();
  await page.getByRole('menuitem', { name: 'New group of selected lights' }).click();
  await expect.poll(() => history(page)).toEqual(['Made Light group of lights']);
  const slider = grid.getByRole('row', { name: 'Light group' }).locator('.slider');
  const box = (await slider.boundingBox())!;
  await page.mouse.move(box.x + box.width - 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2, { steps: 5 });
  const [[half]] = await shining(page, ['Lamp 1']);
  expect(half).toBeGreaterThan(1.8);
  expect(half).toBeLessThan(2.2);
  await page.mouse.up();
  await expect.poll(async () => (await history(page)).length).toBe(2);
  await grid.getByRole('button', { name: 'Solo of Lamp 3' }).click();
  expect((await shining(page, ['Lamp 1', 'Lamp 2', 'Lamp 3'])).map(([, isDrawn]) => isDrawn)).toEqual([
    false,
    false,
    true,
  ]);
  await page.getByRole('button', { name: 'End solo' }).click();
  expect((await shining(page, ['Lamp 1']))[0][1]).toBe(true);
  await expect.poll(async () => (await history(page)).length).toBe(2);
});

it('the keyboard goes through rows, switches and ranges of them; axe finds nothing, and all is in reach, in every size and theme @verify', async ({
  page,
}) => {
  await openLarge(page);
  await page.evaluate(() => window.editor.openScene('temple', { lights: 20 }));
  await openLights(page);
  const grid = page.getByRole('treegrid', { name: 'Lights' });
  await grid.focus();
  await page.keyboard.press('Home');
  await page.keyboard.press('Shift+ArrowDown');
  expect(await page.evaluate(() => window.editor.document.selection.ids.length)).toBe(2);
  await page.keyboard.press('Space');
  expect(await history(page)).toEqual([expect.stringMatching(/^Switched off Light of 2 objects/)]);
  await page.keyboard.press('Control+a');
  expect(await page.evaluate(() => window.editor.document.selection.ids.length)).toBeGreaterThan(20);
  await page.keyboard.press('End');
  await expect(grid.getByRole('row').last()).toHaveAttribute('aria-selected', 'true');
  await page.getByRole('button', { name: 'Group', exact: true }).click();
  await page.getByRole('menuitem', { name: 'New group of selected lights' }).click();
  for (const [width, height] of [
    [2560, 1440],
    [1440, 900],
    [390, 844],
  ]) {
    await page.setViewportSize({ width, height });
    if (width === 390) await page.getByRole('tab', { name: 'Lights' }).click();
    await expect(grid).toBeVisible();
    for (const theme of ['light', 'dark'] as const) {
      await page.evaluate((value) => window.editor.preferences.setState({ theme: value }), theme);
      await expect(page.locator('html')).toHaveAttribute('data-theme', theme);
      expect(await axeProblems(page)).toEqual([]);
    }
    expect(await outOfReach(page)).toEqual([]);
  }
});
