import type { Page } from '@playwright/test';
import { fieldOf, history, serialized } from './editor';
import { dropFiles, growingBox } from './models';
import { expect, test } from './sharedEditor';

test.use({ viewport: { width: 1100, height: 640 } });

/** The weight with which the box is drawn. */
const shown = (page: Page): Promise<number> =>
  page.evaluate(() => {
    let weight = NaN;
    window.editor.document.scene.three.traverse((node) => {
      const { morphTargetInfluences } = node as import('three').Mesh;
      if (morphTargetInfluences) [weight] = morphTargetInfluences;
    });
    return weight;
  });

test('a morph target has a slider: set, undone, recorded as keys, played, and saved', async ({ page }) => {
  await dropFiles(page, '.viewport-place canvas', [growingBox()]);
  await page.getByRole('treeitem', { name: 'growing' }).click();
  const section = page.getByRole('region', { name: 'Model Renderer', exact: true });
  const group = section.getByRole('group', { name: 'Morph targets' });
  const weight = group.getByRole('textbox', { name: 'Tall' });
  await weight.fill('0.5');
  await weight.press('Enter');
  expect(await shown(page)).toBe(0.5);
  expect(await fieldOf(page, 'growing', 'ModelRenderer', 'morphWeights')).toBe('{"Tall":0.5}');
  expect((await history(page)).at(-1)).toBe('Set tall of growing to 0.5');
  await page.keyboard.press('Control+z');
  expect(await shown(page)).toBe(0);

  await page.getByRole('tab', { name: 'Timeline' }).click();
  const panel = page.getByRole('region', { name: 'Timeline' });
  await panel.getByRole('button', { name: 'New clip for growing' }).click();
  await panel.getByRole('button', { name: 'Record' }).click();
  const playhead = panel.getByRole('slider', { name: 'Playhead' });
  await playhead.focus();
  await page.keyboard.press('End');
  await weight.fill('1');
  await weight.press('Enter');
  expect((await history(page)).at(-1)).toBe('Recorded tall in growing clip');
  expect(await shown(page)).toBe(1);
  await playhead.focus();
  await page.keyboard.press('Home');
  await expect.poll(() => shown(page)).toBe(0);
  await panel.getByRole('button', { name: 'Record' }).click();
  const saved = await serialized(page);
  expect(saved).toContain('morph.Tall');
  await page.getByRole('treeitem', { name: 'Sun' }).click();
  await page.keyboard.press('Control+p');
  await expect.poll(() => shown(page)).toBeGreaterThan(0.05);
  await page.getByRole('button', { name: /^Stop/ }).click();
  expect(await shown(page)).toBe(0);
  expect(await serialized(page)).toBe(saved);
});
