import { zipSync } from 'three/addons/libs/fflate.module.js';
import { fieldOf, history, serialized } from './editor';
import { dropFiles, pixelAt } from './models';
import { expect, test } from './sharedEditor';

test.use({ viewport: { width: 1000, height: 560 } });

const picture = '.viewport-place canvas';
const bytes = (text: string): Buffer => Buffer.from(text);

/** A wall before the camera, its texture a TGA of 2 × 2 green texels, another one missing. */
const wall = [
  {
    name: 'wall.obj',
    bytes: bytes(
      'mtllib wall.mtl\nv -9 -9 0\nv 9 -9 0\nv 9 9 0\nv -9 9 0\nvt 0 0\nusemtl moss\nf 1/1 2/1 3/1 4/1\nf 4/1 3/1 2/1 1/1',
    ),
  },
  {
    name: 'wall.mtl',
    bytes: bytes('newmtl moss\nKd 1 1 1\nKs 0.2 0.2 0.2\nmap_Kd t\\Moss.tga\nnorm t\\moss_n.png\nmap_Ks t\\shine.png'),
  },
  {
    // 2 × 2 texels
    name: 'shine.png',
    bytes: Buffer.from(
      'iVBORw0KGgoAAAANSUhEUgAAAAIAAAACCAIAAAD91JpzAAAAD0lEQVR42mNgYPgPRmAKABf2A/3HkIu0AAAAAElFTkSuQmCC',
      'base64',
    ),
  },
  {
    name: 'moss.tga',
    bytes: Buffer.from('00000200000000000000000002000200180000ff0000ff0000ff0000ff00', 'hex'),
  },
];

test('an OBJ in a ZIP comes in with its materials as one asset, and is undone', async ({ page }) => {
  const before = await serialized(page);
  const entries = Object.fromEntries(wall.map(({ name, bytes: each }) => [name, new Uint8Array(each)]));
  await dropFiles(page, picture, [{ name: 'wall.zip', bytes: Buffer.from(zipSync(entries)) }]);
  await expect(page.getByRole('treeitem', { name: 'wall' })).toHaveAttribute('aria-selected', 'true');
  await expect(page.locator('.notices')).toContainText('wall.obj: these textures were not found: t/moss_n.png.');
  expect(await history(page)).toEqual(['Imported wall.glb', 'Added wall']);
  expect(await fieldOf(page, 'wall', 'ModelRenderer', 'model')).toBe('wall.glb');
  await page.locator(picture).focus();
  await page.keyboard.press('f');
  await expect
    .poll(async () => {
      const [red, green] = await pixelAt(page, 0.6, 0.35);
      return green > 60 && green > 2 * red;
    })
    .toBe(true);
  await page.keyboard.press('Control+z');
  await page.keyboard.press('Control+z');
  expect(await serialized(page)).toBe(before);
});

test('Measure this scene opens the Lab, which gets the scene as it is', async ({ page, context }) => {
  await page.evaluate(() => (window.editor.document.scene.name = 'My hall'));
  const opening = context.waitForEvent('page');
  await page.getByRole('menuitem', { name: 'File', exact: true }).click();
  await page.getByRole('menuitem', { name: 'Measure this scene' }).click();
  const lab = await opening;
  await expect(lab).toHaveTitle('My hall · Farol Lab');
  await expect(lab.getByText('My hall').first()).toBeVisible();
});
