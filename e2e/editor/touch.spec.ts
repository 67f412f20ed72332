import { deflateRawSync } from 'node:zlib';
import type { Page } from '@playwright/test';
import type { Scene } from 'three';
import { expect, test } from '../support/test';
import { openEditor } from './editor';
import { type Fingers, makeFingers } from './fingers';
import './player';

declare global {
  interface Window {
    /** Scenes that three has told of. */
    readonly seen: readonly Scene[];
    /** Greatest height of the walker's feet (m). */
    highest: number;
  }
}

test.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

const cameraPlace = (page: Page): Promise<number[]> =>
  page.evaluate(() => window.editor.document.scene.find('Camera')!.object3D.position.toArray());

/** Puts a finger on the left half of a picture and drags it up, as to walk ahead. */
async function pushStick(fingers: Fingers, page: Page): Promise<void> {
  const { x, y, width, height } = (await page.locator('canvas').first().boundingBox())!;
  const [left, middle] = [x + width / 4, y + height / 2];
  await fingers.press([left, middle]);
  await fingers.move([left, middle - 60]);
}

test('a finger leads the camera of a scene that is played in the editor, and Stop puts it back', async ({ page }) => {
  await openEditor(page, 'empty');
  await page.evaluate(() => window.editor.document.scene.find('Camera')!.addComponent('KeyController' as never));
  const before = await cameraPlace(page);
  await page.getByRole('button', { name: 'Play', exact: true }).tap();
  await expect(page.getByText('Tap Stop to put everything back')).toBeVisible();
  const fingers = await makeFingers(page);
  await pushStick(fingers, page);
  await expect(page.locator('[data-touch-stick]')).toBeVisible();
  await expect.poll(async () => (await cameraPlace(page))[2]).toBeLessThan(before[2] - 1);
  await fingers.lift();
  await expect(page.locator('[data-touch-stick]')).toBeHidden();
  await page.getByRole('button', { name: 'Stop, and put everything back' }).tap();
  expect(await cameraPlace(page)).toEqual(before);
});

/** A scene file: a walker with a camera before two steps of 0.2 m. */
function stepsScene(): object {
  const object = (id: string, parent: string | null, place: object, ...components: [string, object][]): object => ({
    ...{ id, name: id, parent },
    components: [['Transform', place], ...components].map(([type, values], i) => ({
      ...{ type, version: 1, id: `${id}-${i}`, values },
    })),
  });
  const block = (id: string, position: number[], scale: number[]): object =>
    object(id, null, { position, scale }, ['ObjectRenderer', {}], ['Collider', {}]);
  return {
    ...{ format: 'farol-scene', version: 3, name: 'Steps', settings: {}, activeCamera: 'camera', assets: [] },
    objects: [
      block('ground', [0, -0.5, 0], [12, 1, 30]),
      block('low', [0, 0, -2], [6, 0.4, 4]),
      block('high', [0, 0.2, -9], [6, 0.4, 10]),
      object('sun', null, { rotation: [-1, 0.3, 0] }, ['Light', { type: 'directional', intensity: 3 }]),
      object('walker', null, { position: [0, 0, 2] }, ['CharacterController', {}]),
      object('camera', 'walker', { position: [0, 1.6, 0] }, ['Camera', {}]),
    ],
  };
}

/** Place of the walker in the page that plays the scene. */
const walkerPlace = (page: Page): Promise<number[]> =>
  page.evaluate(() =>
    window.seen
      .map((scene) => scene.getObjectByName('walker'))
      .find(Boolean)!
      .position.toArray(),
  );

test('in a page that plays a scene a finger walks up steps, and a button jumps @verify', async ({ page }) => {
  await page.addInitScript(() => {
    const tools = new EventTarget();
    const seen: Scene[] = [];
    // three tells its tools of each scene
    tools.addEventListener('observe', (event) => {
      const { detail } = event as CustomEvent<Scene>;
      if (detail.isScene) seen.push(detail);
    });
    Object.assign(window, { __THREE_DEVTOOLS__: tools, seen });
  });
  await page.goto(`./player.html#scene=${deflateRawSync(JSON.stringify(stepsScene())).toString('base64url')}`);
  await expect(page.locator('canvas')).toHaveAttribute('aria-label', 'Steps');
  await page.evaluate(() => window.FarolPlayer.ready);
  const fingers = await makeFingers(page);
  await pushStick(fingers, page);
  await expect.poll(async () => (await walkerPlace(page))[2]).toBeLessThan(-6);
  await fingers.lift();
  // on the second step, which is 0.4 m high; a controller keeps a skin of some mm
  await expect.poll(async () => (await walkerPlace(page))[1]).toBeGreaterThan(0.38);
  const [, ground] = await walkerPlace(page);
  expect(ground).toBeLessThan(0.45);
  await page.evaluate(() => {
    const [walker] = window.seen.map((scene) => scene.getObjectByName('walker')).filter((each) => each !== undefined);
    window.highest = 0;
    const watch = (): void => {
      window.highest = Math.max(window.highest, walker.position.y);
      requestAnimationFrame(watch);
    };
    watch();
  });
  await page.getByRole('button', { name: 'Jump' }).tap();
  await expect.poll(() => page.evaluate(() => window.highest)).toBeGreaterThan(ground + 0.7);
});
