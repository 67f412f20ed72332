import type { Page } from '@playwright/test';
import { expect, test } from '../support/test';
import { openEditor } from './editor';

test.use({ viewport: { width: 1440, height: 900 }, reducedMotion: 'reduce' });

/** Opens the panel and gives it most of the window's height. */
async function openLights(page: Page): Promise<void> {
  await page.getByRole('tab', { name: 'Lights' }).click();
  await expect(page.getByRole('treegrid', { name: 'Lights' })).toBeVisible();
}

const history = (page: Page): Promise<readonly string[]> => page.evaluate(() => window.editor.commands.history);

/** What the three lights of these names give: intensity, and whether they are drawn. */
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

test('lamps are grouped, dimmed by their master and shown alone; each edit is one step, and solo is none', async ({
  page,
}) => {
  await openEditor(page, 'empty');
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
  expect(await history(page)).toEqual(['Made Light group of lights']);
  const slider = grid.getByRole('row', { name: 'Light group' }).locator('.slider');
  const box = (await slider.boundingBox())!;
  await page.mouse.move(box.x + box.width - 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2, { steps: 5 });
  const [[half]] = await shining(page, ['Lamp 1']);
  expect(half).toBeGreaterThan(1.8);
  expect(half).toBeLessThan(2.2);
  await page.mouse.up();
  expect((await history(page)).length).toBe(2);
  await grid.getByRole('button', { name: 'Solo of Lamp 3' }).click();
  expect((await shining(page, ['Lamp 1', 'Lamp 2', 'Lamp 3'])).map(([, isDrawn]) => isDrawn)).toEqual([
    false,
    false,
    true,
  ]);
  await page.getByRole('button', { name: 'End solo' }).click();
  expect((await shining(page, ['Lamp 1']))[0][1]).toBe(true);
  expect((await history(page)).length).toBe(2);
});
