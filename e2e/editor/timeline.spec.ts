import type { Page } from '@playwright/test';
import { axeProblemsInVerify as axeProblems } from '../support/axeProblems';
import { addObject, fieldOf, history, serialized } from './editor';
import { expect, test } from './sharedEditor';

test.use({ viewport: { width: 1100, height: 640 } });

/** Position of the box along x as it is seen, not as it was authored. */
const shownX = (page: Page): Promise<number> =>
  page.evaluate(() => window.editor.document.scene.find('Box')!.object3D.position.x);

test('a clip of two recorded keys: eased, scrubbed, undone, played and stopped', async ({ page }) => {
  await addObject(page, 'Mesh', 'Box');
  const authored = await fieldOf(page, 'Box', 'Transform', 'position');
  await page.getByRole('tab', { name: 'Timeline' }).click();
  const panel = page.getByRole('region', { name: 'Timeline' });
  await panel.getByRole('button', { name: 'New clip for Box' }).click();
  await expect(page.getByRole('region', { name: 'Animation', exact: true })).toBeVisible();

  await panel.getByRole('button', { name: 'Record' }).click();
  const x = page.getByRole('region', { name: 'Transform', exact: true }).getByLabel('Position x');
  await x.fill('0');
  await x.press('Enter');
  const playhead = panel.getByRole('slider', { name: 'Playhead' });
  await playhead.focus();
  await page.keyboard.press('End');
  await expect(playhead).toHaveAttribute('aria-valuetext', '1.00 s, frame 30');
  await x.fill('8 / 2');
  await x.press('Enter');
  await expect.poll(() => shownX(page)).toBe(4);
  expect(await fieldOf(page, 'Box', 'Transform', 'position')).toEqual(authored);
  expect((await history(page)).slice(2)).toEqual(['Recorded position in Box clip', 'Recorded position in Box clip']);
  expect(await axeProblems(page, ['color-contrast'])).toEqual([]);
  await panel.getByRole('button', { name: 'Record' }).click();

  // scrubbed by the mouse to the middle, then to a quarter by frames
  const sheet = (await panel.locator('.timeline-sheet').boundingBox())!;
  await page.mouse.move(sheet.x + 14, sheet.y + 8);
  await page.mouse.down();
  await page.mouse.move(sheet.x + 14 + (sheet.width - 44) / 2, sheet.y + 8, { steps: 3 });
  await page.mouse.up();
  await expect(playhead).toHaveAttribute('aria-valuetext', '0.50 s, frame 15');
  await expect.poll(() => shownX(page)).toBe(2);
  // by a typed number, of frames and of seconds
  const timeOf = async (unit: string, number: string, shown: string): Promise<void> => {
    await panel
      .getByRole('spinbutton', { name: unit, exact: true })
      .or(panel.getByLabel(unit, { exact: true }))
      .fill(number);
    await page.keyboard.press('Enter');
    await expect(playhead).toHaveAttribute('aria-valuetext', shown);
  };
  await timeOf('Time in seconds', '0.2', '0.20 s, frame 6');
  await panel.getByRole('button', { name: 'Show frames' }).click();
  await timeOf('Frame', '15', '0.50 s, frame 15');
  await panel.getByRole('button', { name: 'Show seconds' }).click();
  const text = await serialized(page);
  await panel.getByRole('application', { name: 'Dope sheet' }).focus();
  await page.keyboard.press('Control+a');
  await panel.getByRole('button', { name: 'Easing' }).click();
  await page.getByRole('menuitemcheckbox', { name: 'Ease in', exact: true }).click();
  await expect.poll(() => shownX(page)).toBeLessThan(1.5);
  await page.keyboard.press('Control+z');
  expect(await serialized(page)).toBe(text);
  await expect.poll(() => shownX(page)).toBe(2);
  await page.keyboard.press('Control+y');
  expect((await history(page)).at(-1)).toBe('Eased 2 keys of Box clip');

  // the last key dragged to the middle: one step
  const { y } = (await panel.locator('.timeline-sheet').boundingBox())!;
  await page.mouse.click(sheet.x + 14 + (sheet.width - 44), y + 36);
  await page.mouse.down();
  await page.mouse.move(sheet.x + 14 + (sheet.width - 44) / 2, y + 36, { steps: 4 });
  await page.mouse.up();
  await expect(panel.getByLabel('Time of the key')).toHaveValue('0.5');
  expect((await history(page)).slice(-2)).toEqual(['Eased 2 keys of Box clip', 'Moved 1 key of Box clip']);
  await expect.poll(() => shownX(page)).toBe(4);

  // another object ends the preview; playing moves the box, stopping puts it back
  await page.getByRole('treeitem', { name: 'Sun' }).click();
  await expect.poll(() => shownX(page)).toBe((authored as number[])[0]);
  const before = await serialized(page);
  await page.getByRole('treeitem', { name: 'Box' }).click();
  await page.keyboard.press('Control+p');
  await expect.poll(() => shownX(page)).toBeGreaterThan(0.01);
  await page.getByRole('button', { name: /^Stop/ }).click();
  await expect.poll(() => shownX(page)).toBe((authored as number[])[0]);
  expect(await serialized(page)).toBe(before);
});
