import { pathToFileURL } from 'node:url';
import { deflateRawSync } from 'node:zlib';
import type { Page } from '@playwright/test';
import type { Scene } from 'three';
import { addHeadset, overlaps } from '../support/headset';
import { expect, test } from '../support/test';
import { fieldOf, openEditor, pointOf } from './editor';
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

/** Keeps the scenes that three tells its tools of. This function runs in the pages, before their scripts. */
function seeScenes(): void {
  const tools = new EventTarget();
  const seen: Scene[] = [];
  tools.addEventListener('observe', (event) => {
    const { detail } = event as CustomEvent<Scene>;
    if (detail.isScene) seen.push(detail);
  });
  Object.assign(window, { __THREE_DEVTOOLS__: tools, seen });
}

/** Place (m) of the object that walks in a page that plays a scene, by its name. */
const walkerPlace = (page: Page, name = 'walker'): Promise<number[]> =>
  page.evaluate(
    (name) =>
      window.seen
        .map((scene) => scene.getObjectByName(name))
        .find(Boolean)!
        .position.toArray(),
    name,
  );

test('in a page that plays a scene a finger walks up steps, and a button jumps @verify', async ({ page }) => {
  await page.addInitScript(seeScenes);
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

test('buttons of a headset lie clear of the others, and are read, in a page that plays a scene and in the editor @verify', async ({
  page,
}) => {
  await addHeadset(page);
  await page.goto(`./player.html#scene=${deflateRawSync(JSON.stringify(stepsScene())).toString('base64url')}`);
  const buttons = page.getByRole('button', { name: /Enter|Jump/ });
  await expect(buttons).toHaveCount(3);
  expect(await overlaps(buttons)).toEqual([]);

  await openEditor(page, 'empty');
  await page.evaluate(() => window.editor.preferences.setState({ theme: 'light' }));
  await page.getByRole('button', { name: 'Play', exact: true }).tap();
  await expect(buttons).toHaveCount(2);
  const unread = (): Promise<string[]> =>
    buttons.evaluateAll((all) =>
      all
        .map((each) => ({ style: getComputedStyle(each), cut: each.scrollWidth > each.clientWidth }))
        .filter(({ style, cut }) => style.color === style.backgroundColor || cut)
        .map(({ style, cut }) => `${style.color} on ${style.backgroundColor}${cut ? ', cut' : ''}`),
    );
  await expect.poll(unread).toEqual([]);
});

test('Stop ends the session of a headset in which the scene plays @verify', async ({ page }) => {
  await addHeadset(page);
  await openEditor(page, 'empty');
  const isShown = () => page.evaluate(() => window.editor.viewport.picture.inXR);
  await page.getByRole('button', { name: 'Play', exact: true }).tap();
  await page.getByRole('button', { name: 'Enter VR' }).tap();
  await expect.poll(isShown).toBe(true);
  await page.getByRole('button', { name: 'Stop, and put everything back' }).dispatchEvent('click');
  await expect.poll(isShown).toBe(false);
});

test('fingers place a lamp, move it and colour it', async ({ page }) => {
  await openEditor(page, 'empty');
  await page.getByRole('button', { name: 'Add', exact: true }).tap();
  await page.getByRole('menuitem', { name: 'Light', exact: true }).tap();
  await page.getByRole('menuitem', { name: 'Point light' }).tap();
  await expect(page.getByText('1 selected')).toBeVisible();
  await page.getByRole('tab', { name: 'Inspector' }).tap();
  // the last field that is seen: help that came beneath it used to push it away from under the finger
  await page.getByRole('button', { name: 'Colour', exact: true }).tap({ timeout: 20_000 });
  const picker = page.getByRole('dialog', { name: 'Colour' });
  await picker.getByRole('slider', { name: 'Hue' }).tap();
  await picker.getByRole('slider', { name: 'Saturation and brightness' }).tap();
  // #408080: the middle of all hues, half as bright and half as strong
  await expect
    .poll(() => fieldOf(page, 'Point light', 'Light', 'diffuse'))
    .toEqual([expect.closeTo(0.05, 2), expect.closeTo(0.22, 2), expect.closeTo(0.22, 2)]);
  // what is outside closes the picker
  await page.getByRole('searchbox', { name: 'Find a field' }).tap({ position: { x: 20, y: 12 } });
  await expect(picker).toBeHidden();
  await page.locator('[data-help]').getByText('Intensity', { exact: true }).tap();
  await expect(page.locator('.inspector-help')).toContainText(/./);
  const place = (await fieldOf(page, 'Point light', 'Transform', 'position')) as number[];
  const fingers = await makeFingers(page);
  // the red arrow of the handles points to the right here
  const { x, y } = await pointOf(page, 'Point light');
  await fingers.press([x + 50, y]);
  await fingers.move([x + 110, y]);
  await fingers.lift();
  const moved = (await fieldOf(page, 'Point light', 'Transform', 'position')) as number[];
  expect(moved[0]).toBeGreaterThan(place[0] + 0.5);
});

test.describe('in half as many pixels', () => {
  test.use({ deviceScaleFactor: 0.5 });

  test('a finger walks up the steps of the temple in an exported page @verify', async ({ page, context }, info) => {
    test.setTimeout(300_000);
    await openEditor(page, 'empty');
    await page.evaluate(async () => {
      window.editor.viewport.renderNow = () => {};
      await window.editor.openSample('night-in-the-temple');
    });
    await page.keyboard.press('Control+Shift+E');
    const download = page.waitForEvent('download');
    await page.getByRole('button', { name: 'Web page…' }).tap();
    const html = info.outputPath('temple.html');
    await (await download).saveAs(html);
    const played = await context.newPage();
    await played.addInitScript(seeScenes);
    await played.goto(pathToFileURL(html).href);
    await expect(played.locator('canvas')).toHaveAttribute('aria-label', 'Night in the temple');
    await played.evaluate(() => window.FarolPlayer.ready);
    const fingers = await makeFingers(played);
    await pushStick(fingers, played);
    // two of the steps; the ground outside lies at 0
    await expect.poll(async () => (await walkerPlace(played, 'Player'))[1], { timeout: 200_000 }).toBeGreaterThan(0.35);
    await fingers.lift();
  });
});

test(
  'a finger that rests on an item of the library drags it into the picture',
  { tag: '@verify' },
  async ({ page }) => {
    await openEditor(page, 'empty');
    await page.getByRole('tab', { name: 'Library' }).tap();
    const card = page.getByRole('region', { name: 'Library' }).getByRole('button', { name: 'Lantern' });
    const from = (await card.boundingBox())!;
    const picture = (await page.locator('.viewport-place canvas').first().boundingBox())!;
    const fingers = await makeFingers(page);
    const names = (): Promise<string[]> =>
      page.evaluate(() => window.editor.document.scene.roots.map((object) => object.name));
    await fingers.press([from.x + from.width / 2, from.y + from.height / 2]);
    await expect(page.locator('.library-dragged')).toHaveCount(1);
    await fingers.move([picture.x + picture.width * 0.3, picture.y + picture.height * 0.8]);
    await fingers.lift();
    await expect.poll(names).toEqual(['Camera', 'Sun', 'Sky', 'Lantern']);
    await expect(page.locator('.library-dragged')).toHaveCount(0);
    // a tap adds at the middle of the view
    await card.tap();
    await expect.poll(names).toEqual(['Camera', 'Sun', 'Sky', 'Lantern', 'Lantern 2']);
  },
);
