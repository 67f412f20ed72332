import type { Light } from '@farol/engine';
import type { Page } from '@playwright/test';
import { addObject } from './editor';
import { expect, test } from './sharedEditor';

test.use({ viewport: { width: 1440, height: 900 } });

/**
 * A plane under a board, a sun from above and a lamp beside them.
 * @returns places of the picture in the light, and in the board's shadow (CSS pixels)
 */
async function makeScene(page: Page): Promise<{ x: number; y: number }[]> {
  await addObject(page, 'Mesh', 'Plane');
  await addObject(page, 'Mesh', 'Box');
  await addObject(page, 'Light', 'Point light');
  return page.evaluate(() => {
    const { viewport, document } = window.editor;
    const { scene, selection } = document;
    const plane = scene.find('Plane')!;
    // to the right of the tool's box
    plane.transform.set('position', [2.5, 0, -1]);
    const { position } = plane.object3D;
    for (const light of scene.componentsOf<Light>('Light')) {
      const { transform } = light.gameObject;
      if (light.type === 'directional') {
        Object.assign(light, { intensity: 2, castShadow: true });
        transform.set('rotation', [-Math.PI / 2, 0, 0]);
      } else if (light.type === 'point') {
        Object.assign(light, { intensity: 3, range: 6, castShadow: false });
        transform.set('position', [position.x + 1, position.y + 1.5, position.z]);
      } else light.enabled = false;
    }
    const board = scene.find('Box')!.transform;
    board.set('position', [position.x, position.y + 1, position.z]);
    board.set('scale', [1, 0.05, 1]);
    selection.set([]);
    viewport.renderNow();
    const { width, height } = viewport.canvas.getBoundingClientRect();
    return [-0.9, 0].map((x) => {
      const { x: u, y: v } = position
        .clone()
        .set(position.x + x, position.y, position.z)
        .project(viewport.camera as never);
      return { x: ((u + 1) / 2) * width, y: ((1 - v) / 2) * height };
    });
  });
}

test('a pixel tells of its lights, in the light and in a shadow; a row selects its light, a button the material’s object @verify', async ({
  page,
}) => {
  const places = await makeScene(page);
  const canvas = page.locator('.viewport-place canvas');
  await canvas.focus();
  await page.keyboard.press('Shift+M');
  const box = page.getByRole('region', { name: 'Explain a pixel' });
  await expect(box).toBeVisible();
  await canvas.click({ position: places[0] });
  const sun = box.getByRole('row', { name: /Sun|Directional/ });
  const lamp = box.getByRole('row', { name: /Point light/ });
  const percents = (row: typeof sun): Promise<number[]> =>
    row.getByRole('cell').evaluateAll((cells) => cells.slice(0, 2).map(({ textContent }) => parseFloat(textContent)));
  await expect(lamp).toContainText(/\d %.*\d %.*\d m.*\d %/);
  const [[bright], [dim]] = [await percents(sun), await percents(lamp)];
  expect(bright + dim).toBeGreaterThan(60);
  expect(bright).toBeGreaterThan(dim);

  await canvas.click({ position: places[1] });
  await expect(sun.getByRole('cell').first()).toHaveText('0 %');
  expect((await percents(sun))[1]).toBeGreaterThan(50);
  expect((await percents(lamp))[0]).toBeGreaterThan(40);
  expect(await page.evaluate(() => window.editor.document.selection.ids)).toEqual([]);

  await lamp.getByRole('button').click();
  const selected = (): Promise<string[]> =>
    page.evaluate(() => window.editor.document.selectedObjects.map(({ name }) => name));
  expect(await selected()).toEqual(['Point light']);
  await box
    .getByRole('button', { name: 'Its own material' })
    .or(box.getByRole('button', { name: 'Plane' }))
    .first()
    .click();
  expect(await selected()).toEqual(['Plane']);
  await box.getByText('Microshaders that ran').click();
  await expect(box.getByText(/incidentLight/).first()).toBeVisible();
  await canvas.focus();
  await page.keyboard.press('Escape');
  await expect(box).toBeHidden();
});
