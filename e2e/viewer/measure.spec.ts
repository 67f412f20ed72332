import { expect, test } from '../support/test';
import { drop } from '../support/drop';
import { openViewer, still } from '../support/viewer';

const obj = 'v -1 0 0\nv 1 0 0\nv 1 2 0\nf 1 2 3\n';

test('a dropped model is handed to the Lab, and a demo scene goes by its address', async ({ page, context }) => {
  await openViewer(page, { ...still, gui: 1 });
  const measure = page.getByRole('button', { name: 'Measure this scene' });
  let opening = context.waitForEvent('page');
  await measure.click();
  const demo = await opening;
  await expect(demo).toHaveURL(/#preset=custom&series=benchmarkLights:lights:2,5,9,18,36:n=4$/);
  await demo.close();

  await drop(page, { 'room.obj': obj });
  await expect.poll(() => page.evaluate(() => window.viewer.modelName)).toBe('room.obj');
  opening = context.waitForEvent('page');
  await measure.click();
  const lab = await opening;
  await expect(lab).toHaveTitle('room.obj · Farol Lab');
  await expect(lab.getByText('room.obj').first()).toBeVisible();
  await lab.close();

  // without an address of the Lab
  await page.route('**/apps.json', (route) => route.fulfill({ json: {} }));
  await measure.click();
  await expect(page.locator('.message[data-subject=lab]')).toHaveText(/^The address of the Lab is unknown/);
});
