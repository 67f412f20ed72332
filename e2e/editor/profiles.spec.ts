import type { Light } from '@farol/engine';
import type { Page } from '@playwright/test';
import { addObject, history, serialized } from './editor';
import { dropFiles, pixelAt } from './models';
import { expect, test } from './sharedEditor';

test.use({ viewport: { width: 1000, height: 620 } });

/** Light to one side alone, 800 cd at 45°. */
const aside = `IESNA:LM-63-2002
[MANUFAC] Journeys
TILT=NONE
1 -1 1 5 3 1 2 0 0 0
1 1 10
0 22.5 45 67.5 90
0 90 180
0 400 800 400 0
0 100 200 100 0
0 0 0 0 0
`;

/** Brightness of the floor 1.2 m to the right and to the left of the light. */
async function sides(page: Page): Promise<number[]> {
  const places = await page.evaluate(() => {
    const { viewport, document } = window.editor;
    const { position } = document.scene.find('Point light')!.object3D;
    return [1.2, -1.2].map((x) => {
      const place = position
        .clone()
        .set(position.x + x, 0, position.z)
        .project(viewport.camera as never);
      return [(place.x + 1) / 2, (1 - place.y) / 2];
    });
  });
  const seen: number[] = [];
  for (const [x, y] of places) seen.push((await pixelAt(page, x, y))[1]);
  return seen;
}

test('a photometric file is dropped on a light, which it shapes; its curve is seen, and all is undone', async ({
  page,
}) => {
  await addObject(page, 'Mesh', 'Plane');
  await addObject(page, 'Light', 'Point light');
  await page.evaluate(() => {
    const { scene } = window.editor.document;
    for (const light of scene.componentsOf<Light>('Light')) light.enabled = light.type === 'point';
    scene.find('Point light')!.transform.position = [0, 1.5, 0];
  });
  const before = await serialized(page);
  const steps = (await history(page)).length;
  const [right, left] = await sides(page);
  expect(Math.min(right, left)).toBeGreaterThan(60);

  const row = '[role="treeitem"]:has-text("Point light")';
  await dropFiles(page, row, [{ name: 'aside.ies', bytes: Buffer.from(aside) }]);
  await expect.poll(() => history(page)).toHaveLength(steps + 2);
  expect((await history(page)).slice(steps)).toEqual(['Imported aside.ies', 'Gave aside.ies to Point light']);
  const curve = page.getByRole('img', { name: 'Polar curve of aside.ies. Largest intensity 800 cd' });
  await expect(curve).toBeVisible();
  // C0 to the right, C180, which has no light, not to the left
  const ends = await curve
    .locator('path.polar-plane')
    .last()
    .evaluate((path: SVGGraphicsElement) => {
      const { x, width } = path.getBBox();
      return [x, x + width];
    });
  expect(ends[0]).toBeCloseTo(0, 1);
  expect(ends[1]).toBeGreaterThan(50);
  const [lit, dark] = await sides(page);
  expect(lit).toBeGreaterThan(right * 0.5);
  expect(dark).toBeLessThan(left * 0.3);

  await page.getByRole('checkbox', { name: 'Brightness of the file' }).click();
  const intensity = () =>
    page.evaluate(() => {
      const lights = window.editor.document.scene.componentsOf<Light>('Light');
      return lights.find(({ type }) => type === 'point')!.three.intensity;
    });
  await expect.poll(intensity).toBe(12 * 800);
  for (let i = 0; i < 3; i++) await page.keyboard.press('Control+z');
  expect(await serialized(page)).toBe(before);
  await expect(curve).toHaveCount(0);
  expect(await sides(page)).toEqual([right, left]);
});

test('a photometric file comes with the tilt of its lamps in a file of its own, and names that one when it is missing', async ({
  page,
}) => {
  const bytes = Buffer.from(aside.replace('TILT=NONE', 'TILT=LAMP.TLT'));
  await dropFiles(page, '.assets-body', [{ name: 'aside.ies', bytes }]);
  await expect(
    page.getByText(/aside\.ies cannot be imported: Line 3: .* in another file, "LAMP\.TLT"; give that one/),
  ).toBeVisible();
  const tilt = Buffer.from('1\n2\n0 90\n0.5 1\n');
  await dropFiles(page, '.assets-body', [
    { name: 'aside.ies', bytes },
    { name: 'lamp.tlt', bytes: tilt },
  ]);
  const known = () =>
    page.evaluate(() => {
      const { assets } = window.editor.document;
      const names = assets.files.map(({ name }) => name);
      return names.includes('aside.ies') && assets.isReady('profile', 'aside.ies')
        ? [names, assets.profile('aside.ies').maximumIntensity]
        : null;
    });
  // half as much light in the position in which it was measured
  await expect.poll(known).toEqual([['aside.ies'], 400]);
});
