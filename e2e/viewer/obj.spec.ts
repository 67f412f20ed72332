import type { Page } from '@playwright/test';
import { drop } from '../support/drop';
import { compareImages } from '../support/images';
import { readImage } from '../support/viewer';
import { expect, test } from './sharedViewer';

/** A square that faces the camera, without normals, with Windows paths. */
const obj = `mtllib Room.MTL
v -1 0 0
v 1 0 0
v 1 2 0
v -1 2 0
vt 0 0
vt 1 0
vt 1 1
vt 0 1
usemtl wall
f -4/-4 -3/-3 -2/-2 -1/-1
`;
const mtl = `newmtl wall\r
\tNs 10\r
\tKd 1 1 1\r
\tKs 0 0 0\r
\tmap_Kd Textures\\Blue Wall.TGA\r
\tmap_bump textures\\bump.png\r
`;

/** TGA of 2 × 2 blue texels of 24 bits, each in the order blue, green, red. */
const blueTga = Buffer.from('000002000000000000000000020002001800ff0000ff0000ff0000ff0000', 'hex');

/** Mean red and mean blue of the middle of the picture. */
async function middle(page: Page): Promise<{ red: number; blue: number }> {
  const { width, height, data } = await readImage(page);
  const at = (Math.floor(height / 2) * width + Math.floor(width / 2)) * 4;
  return { red: data[at], blue: data[at + 2] };
}

test('an OBJ is shown with its MTL and a TGA, and one message names what is missing', async ({ page }) => {
  const before = await readImage(page);
  await drop(page, { 'room.obj': obj, 'room.mtl': mtl, 'blue wall.tga': blueTga });
  await expect.poll(() => page.evaluate(() => window.viewer.modelName)).toBe('room.obj');
  await expect(page.locator('.message')).toHaveCount(1);
  await expect(page.locator('.message')).toHaveText(
    /^room\.obj: these textures were not found: textures\/bump\.png\. Drop/,
  );
  expect(compareImages(before, await readImage(page)).largest).toBeGreaterThan(0.05);
  const blue = await middle(page);
  expect(blue.blue).toBeGreaterThan(0.05);
  expect(blue.blue).toBeGreaterThan(4 * blue.red);

  // without its MTL, by the menu: grey, and a message
  const chooser = page.waitForEvent('filechooser');
  await page.getByRole('button', { name: 'Open a model…' }).click();
  await (await chooser).setFiles({ name: 'bare.obj', mimeType: 'text/plain', buffer: Buffer.from(obj) });
  await expect(page.locator('.message')).toHaveText(
    /^bare\.obj: it is grey, since its materials were not found: Room\.MTL\./,
  );
  const grey = await middle(page);
  expect(grey.red).toBeGreaterThan(0.05);
  expect(grey.blue).toBeLessThan(2 * grey.red);

  await drop(page, { 'cut.obj': obj.slice(0, obj.indexOf('v 1 2')) + 'f 1 2 3' });
  await expect(page.locator('.message')).toHaveText(
    /^cut\.obj: line 4: a face names vertex 3, and the file has 2: export/,
  );
  expect(await page.evaluate(() => window.viewer.modelName)).toBe('bare.obj');
});
