import { readFile } from 'node:fs/promises';
import type { Page } from '@playwright/test';
import { history } from './editor';
import { expect, test } from './sharedEditor';

test.use({ viewport: { width: 900, height: 520 } });

const object = (id: string, values: object, ...components: readonly [string, object][]): object => ({
  ...{ id, name: id, parent: null },
  components: [['Transform', values] as const, ...components].map(([type, fields], i) => ({
    ...{ type, version: 1, id: `${id}-${i}`, values: fields },
  })),
});

/** A floor, a block, a ball that may move, and a lamp, all as they are made: nothing is static, and the lamp is drawn. */
const scene = JSON.stringify({
  ...{ format: 'farol-scene', version: 3, name: 'Room', activeCamera: 'Camera', assets: [] },
  settings: {
    ...{ technique: 'deferred', antialiasing: 'none', backgroundColour: [0, 0, 0] },
    ...{ bakeSize: '64', bakeSamples: 2, bakeBounces: 0, bakeSky: false, bakeDenoise: false, bakeProbeSpacing: 4 },
  },
  objects: [
    object('Camera', { position: [0, 3, 4], rotation: [-0.6, 0, 0] }, ['Camera', {}]),
    object('Floor', { scale: [4, 1, 4] }, ['ObjectRenderer', { mesh: 'plane', colour: [0.8, 0.8, 0.8] }]),
    object('Block', { position: [-0.9, 0.3, 0], scale: [0.6, 0.6, 0.6] }, ['ObjectRenderer', { mesh: 'box' }]),
    object(
      'Ball',
      { position: [0.9, 0.5, 0], scale: [0.8, 0.8, 0.8] },
      ['ObjectRenderer', { mesh: 'sphere' }],
      ['RandomMovement', {}],
    ),
    object('Lamp', { position: [0, 2, 0.8] }, ['Light', { intensity: 6, range: 0 }]),
  ],
});

interface Picture {
  readonly data: string;
  /** Mean of each channel, 0 to 255, where the floor, and where the ball is. */
  readonly floor: number;
  readonly ball: number;
  readonly lights: number;
}

/** Pixels of the viewport, drawn now. */
const pictureOf = (page: Page): Promise<Picture> =>
  page.evaluate(async () => {
    const { viewport, document: edited } = window.editor;
    viewport.renderNow();
    const { canvas } = viewport;
    // other pictures, such as thumbnails, may be drawn while this one is decoded
    const lights = viewport.farol.info.lights.total;
    const data = canvas.toDataURL();
    const copy = document.createElement('canvas');
    [copy.width, copy.height] = [canvas.width, canvas.height];
    const context = copy.getContext('2d', { willReadFrequently: true })!;
    const image = new Image();
    image.src = data;
    await image.decode();
    context.drawImage(image, 0, 0);
    const brightness = (x: number, y: number, z: number): number => {
      const point = edited.scene
        .find('Camera')!
        .object3D.position.clone()
        .set(x, y, z)
        .project(viewport.camera as never);
      const [left, top] = [((point.x + 1) / 2) * copy.width, ((1 - point.y) / 2) * copy.height];
      const { data: texels } = context.getImageData(Math.round(left) - 2, Math.round(top) - 2, 5, 5);
      let sum = 0;
      for (let i = 0; i < texels.length; i += 4) sum += texels[i];
      return sum / 25;
    };
    return { data, floor: brightness(0.1, 0, 1.2), ball: brightness(0.9, 0.8, 0.2), lights };
  });

test('light is baked: it stays when the light is gone, is one step, is saved, and tells when it is out of date', async ({
  page,
}) => {
  await page.evaluate((text) => window.editor.openFileBytes(text, { name: null, handle: null }), scene);
  await page.evaluate(() => {
    const { viewport } = window.editor as unknown as { viewport: { showGrid: boolean; showIcons: boolean } };
    viewport.showGrid = viewport.showIcons = false;
  });
  await page.getByRole('menuitem', { name: 'Object', exact: true }).click();
  await page.getByRole('menuitem', { name: 'Bake light…' }).click();
  const panel = page.getByRole('region', { name: 'Baked light' });
  await panel.getByRole('button', { name: 'Make 2 objects static' }).click();
  await panel.getByRole('button', { name: 'Set 1 light to Baked' }).click();
  await expect(panel.getByText('2 static objects, 1 baked light')).toBeVisible();
  const before = await pictureOf(page);
  expect(before.lights).toBe(1);
  const stitch = panel.getByRole('checkbox', { name: 'Stitch seams' });
  await stitch.uncheck();
  await page.keyboard.press('Control+z');
  await expect(stitch).toBeChecked();

  await panel.getByRole('button', { name: 'Bake', exact: true }).click();
  await expect(panel.getByText('2 meshes')).toBeVisible({ timeout: 60_000 });
  expect(await history(page)).toEqual(['Made static: 2 objects', 'Made baked: Lamp', 'Baked the light']);
  // the picture follows as soon as the lightmap's file is decoded
  await expect.poll(() => pictureOf(page).then(({ lights }) => lights)).toBe(0);
  const baked = await pictureOf(page);
  // the floor as before, within the noise of four samples; the ball by the probes alone, softer than by the lamp
  expect(Math.abs(baked.floor - before.floor)).toBeLessThan(12);
  expect(baked.ball).toBeGreaterThan(20);

  await page.keyboard.press('Control+z');
  expect(await pictureOf(page)).toEqual(before);
  await page.keyboard.press('Control+y');
  await expect.poll(() => pictureOf(page)).toEqual(baked);

  const download = page.waitForEvent('download');
  await page.keyboard.press('Control+s');
  const bytes = [...(await readFile(await (await download).path()))];
  await page.evaluate(async (file) => {
    const { editor } = window as unknown as {
      editor: { openFileBytes(bytes: Uint8Array, file: object): Promise<boolean> };
    };
    await editor.openFileBytes(Uint8Array.from(file), { name: 'Room.farol', handle: null });
  }, bytes);
  await expect(panel.getByText('2 meshes')).toBeVisible();
  await expect.poll(() => pictureOf(page)).toEqual(baked);

  const outOfDate = panel.getByText('Out of date');
  await expect(outOfDate).toBeHidden();
  await page.evaluate(() => (window.editor.document.scene.find('Block')!.transform.position = [-0.9, 0.4, 0]));
  await expect(outOfDate).toBeVisible();
  await panel.getByRole('button', { name: 'Clear' }).click();
  expect((await pictureOf(page)).lights).toBe(1);
});
