import type { Page } from '@playwright/test';
import { Quaternion, Vector3 } from 'three';
import type { Light } from '@farol/engine';
import { byExtent } from '@farol/tools/extent';
import { compareImages } from '../support/images';
import { addHeadset, overlaps } from '../support/headset';
import { test as own } from '../support/test';
import { addressOf, openViewer, readImage, still } from '../support/viewer';
import { expect, test } from './sharedViewer';

const withMenu = { ...still, gui: 1 };
/** Lets time go on. */
const startTime = (page: Page) =>
  page.evaluate(() =>
    (window.viewer as typeof window.viewer & { setTime(seconds: number | null): void }).setTime(null),
  );

interface Pose {
  position: number[];
  turn: number[];
}

/** How near the lines of sight of two cameras come to each other (m). */
function lineDistance(a: Pose, b: Pose): number {
  const front = ({ turn }: Pose) => new Vector3(0, 0, -1).applyQuaternion(new Quaternion(...turn));
  const between = new Vector3(...b.position).sub(new Vector3(...a.position));
  return Math.abs(between.dot(front(a).cross(front(b)).normalize()));
}

test('the menu offers every technique, view and scene, and writes them into the address', async ({ page }) => {
  const known = await page.evaluate(() => {
    const { scenes, techniques, views } = window.viewer.known;
    return { scenes: Object.keys(scenes), techniques: [...techniques], views: [...views] };
  });
  const row = (name: string) => page.locator('.lil-controller', { hasText: name });
  const types = row('Technique').locator('select');
  const views = row('View').locator('select');
  await expect(types.locator('option')).toHaveCount(known.techniques.length);
  await expect(views.locator('option')).toHaveText(
    known.views.map((name) => new RegExp(`^${name.replace('-', '.')}$`, 'i')),
  );
  await expect(
    page.locator('.lil-gui', { hasText: 'Scenes' }).last().locator('button.lil-title ~ * button'),
  ).toHaveCount(known.scenes.length);

  for (const [index, technique] of known.techniques.entries()) {
    await types.selectOption({ index });
    await expect.poll(async () => (await addressOf(page)).technique).toBe(technique);
    expect(await page.evaluate(() => window.viewer.farol.technique)).toBe(technique);
  }
  const budget = row('Frame budget').locator('select');
  await expect(budget.locator('option')).toHaveText(['On touch screens', 'On', 'Off']);
  await budget.selectOption('On');
  await expect.poll(async () => (await addressOf(page)).budget).toBe('on');
  await expect.poll(() => page.evaluate(() => window.viewer.farol.budget !== null)).toBe(true);
  await budget.selectOption('On touch screens');
  await expect(row('Quality').locator('option')).toHaveText(['Automatic', 'Full', 'Lite']);
  await views.selectOption('Normal');
  await expect.poll(async () => (await addressOf(page)).view).toBe('normal');
  expect(await page.evaluate(() => window.viewer.farol.view)).toBe('normal');
});

own('the address that the menu wrote opens the same picture @verify', async ({ page }) => {
  await openViewer(page, withMenu);
  const before = await readImage(page);
  await page.getByRole('button', { name: 'Temple' }).click();
  await expect.poll(async () => (await addressOf(page)).scene).toBe('temple');
  const chosen = await readImage(page);
  expect(compareImages(before, chosen).largest).toBeGreaterThan(0.05);

  await page.reload();
  await page.evaluate(() => window.viewer.ready);
  expect(compareImages(chosen, await readImage(page)).largest).toBe(0);
});

own('a number of lights set in the menu is in the scene and the address, and the camera stays', async ({ page }) => {
  await openViewer(page, { ...withMenu, scene: 'temple', lights: 10 });
  const place = await page.evaluate(() => {
    const { object3D } = window.viewer.engineScene.activeCamera!.gameObject;
    object3D.position.x += 1;
    window.viewer.renderAt(1);
    return object3D.position.toArray();
  });
  const input = page
    .locator('.lil-controller', { hasText: /^lights$/i })
    .locator('input[type=text]')
    .first();
  await input.fill('7');
  await input.press('Enter');
  await expect.poll(async () => (await addressOf(page)).lights).toBe('7');
  await expect
    .poll(() =>
      page.evaluate(
        () => window.viewer.engineScene.componentsOf<Light>('Light').filter((l) => l.type === 'point').length,
      ),
    )
    .toBe(7);
  const after = await page.evaluate(() =>
    window.viewer.engineScene.activeCamera!.gameObject.object3D.position.toArray(),
  );
  for (const axis of [0, 1, 2]) expect(after[axis]).toBeCloseTo(place[axis], 4);
});

test('keys fly and dragging turns the camera', async ({ page }) => {
  await startTime(page);
  const pose = () =>
    page.evaluate(() => {
      const { object3D } = window.viewer.engineScene.activeCamera!.gameObject;
      return { position: object3D.position.toArray(), turn: object3D.quaternion.toArray() };
    });
  const before = await pose();
  await page.locator('canvas').click();
  await page.keyboard.down('KeyW');
  await expect.poll(async () => (await pose()).position).not.toEqual(before.position);
  await page.keyboard.up('KeyW');
  await page.mouse.move(80, 45);
  await page.mouse.down();
  await page.mouse.move(120, 50, { steps: 3 });
  await page.mouse.up();
  await expect.poll(async () => (await pose()).turn).not.toEqual(before.turn);
});

test('a finger orbits the scene: the camera moves and keeps looking at the same place', async ({ page }) => {
  const pose = () =>
    page.evaluate(() => {
      const { object3D } = window.viewer.engineScene.activeCamera!.gameObject;
      return { position: object3D.position.toArray(), turn: object3D.quaternion.toArray() };
    });
  const before = await pose();
  const picture = await readImage(page);
  const devtools = await page.context().newCDPSession(page);
  const touch = (type: 'touchStart' | 'touchMove' | 'touchEnd', x?: number) =>
    devtools.send('Input.dispatchTouchEvent', { type, touchPoints: x === undefined ? [] : [{ x, y: 45 }] });
  await touch('touchStart', 60);
  for (const x of [70, 80, 100]) await touch('touchMove', x);
  await touch('touchEnd');
  await expect.poll(async () => (await pose()).position).not.toEqual(before.position);
  const after = await pose();
  expect(after.turn).not.toEqual(before.turn);
  expect(lineDistance(before, after), 'distance of the two lines of sight (m)').toBeLessThan(1e-3);
  expect(compareImages(picture, await readImage(page)).largest).toBeGreaterThan(0.02);
});

test('while time is stopped the camera flies, the scene stands, and no frame is drawn in between', async ({ page }) => {
  const state = () =>
    page.evaluate(() => ({
      place: window.viewer.engineScene.activeCamera!.gameObject.object3D.position.toArray(),
      time: window.viewer.engineScene.time,
      frame: window.viewer.three.info.render.frame,
    }));
  const before = await state();
  await page.locator('canvas').click();
  await page.keyboard.down('KeyW');
  await expect.poll(async () => (await state()).place).not.toEqual(before.place);
  await page.keyboard.up('KeyW');
  /** Frames that are drawn in a turn of the page. */
  const drawn = async () => {
    const { frame } = await state();
    await page.evaluate(() => new Promise(requestAnimationFrame));
    return (await state()).frame - frame;
  };
  await expect.poll(drawn).toBe(0);
  expect((await state()).time).toBe(before.time);
});

test('Space stops time and lets it go on, H hides the menu; the address follows', async ({ page }) => {
  await startTime(page);
  await expect.poll(() => page.evaluate(() => window.viewer.engineScene.time)).toBeGreaterThan(0.05);
  await page.keyboard.press('Space');
  const time = Number((await addressOf(page)).time);
  expect(time).toBeGreaterThan(0);
  expect(await page.evaluate(() => window.viewer.engineScene.time)).toBe(time);
  await page.keyboard.press('Space');
  await expect.poll(() => page.evaluate(() => window.viewer.engineScene.time)).toBeGreaterThan(time);
  expect((await addressOf(page)).time).toBeUndefined();
  await page.keyboard.press('h');
  await expect(page.locator('.lil-gui.lil-root')).toBeHidden();
  expect((await addressOf(page)).gui).toBe('0');
});

test('figures of each pass are shown and kept up', async ({ page }) => {
  await startTime(page);
  const rows = page.locator('.statistics tbody tr');
  await expect(rows).not.toHaveCount(0);
  await expect(page.locator('.statistics')).toContainText(/\d+ frames a second/);
  const names = await page.evaluate(() => window.viewer.farol.info.passes.map((pass) => pass.name));
  expect(await rows.locator('td:first-child').allTextContents()).toEqual(names);
});

test('the help lists keys and address parameters', async ({ page }) => {
  await page.keyboard.press('?');
  const help = page.getByRole('dialog', { name: 'Help' });
  await expect(help).toBeVisible();
  // in a low window it is read from its beginning
  expect(
    await help.evaluate(({ scrollHeight, clientHeight, scrollTop }) => [scrollHeight > clientHeight, scrollTop]),
  ).toEqual([true, 0]);
  for (const text of ['W A S D', '?technique=', '?lights=', '?dpr=']) await expect(help).toContainText(text);
  await page.keyboard.press('Escape');
  await expect(help).toBeHidden();
});

own('buttons of a headset lie beside the help', async ({ page }) => {
  await addHeadset(page);
  await page.setViewportSize({ width: 390, height: 844 });
  await openViewer(page, still);
  await expect(page.getByRole('button', { name: /Enter/ })).toHaveText(['Enter VR', 'Enter AR']);
  expect(await overlaps(page.locator('#app > button'))).toEqual([]);
});

own('a lost graphics device is told of, and the picture comes back by every technique', async ({ page, watch }) => {
  await openViewer(page, withMenu);
  const techniques = await page.evaluate(() => {
    const extension = window.viewer.three.getContext().getExtension('WEBGL_lose_context')!;
    Object.assign(window, { losing: extension });
    return [...window.viewer.known.techniques];
  });
  for (const technique of byExtent({ slice: ['deferred'], verify: techniques })) {
    await page.evaluate((name) => window.viewer.setTechnique(name), technique);
    const before = await readImage(page);
    await page.evaluate(() => (window as unknown as { losing: WEBGL_lose_context }).losing.loseContext());
    await expect(page.locator('.message')).toContainText('graphics device was lost');
    await page.evaluate(() => (window as unknown as { losing: WEBGL_lose_context }).losing.restoreContext());
    await expect(page.locator('.message')).toHaveCount(0);
    expect(compareImages(before, await readImage(page)).largest, technique).toBe(0);
    expect(watch.forgive(/a WebGL context was lost|THREE.WebGLRenderer: Context Lost/)).toBeGreaterThan(0);
  }
});

own.describe('on a phone', () => {
  own.use({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true });

  own('the menu is folded at first, so that the picture is seen, and opens by its title', async ({ page }) => {
    const technique = page.getByLabel('Technique');
    for (const [width, height] of [
      [844, 390],
      [390, 844],
    ]) {
      await page.setViewportSize({ width, height });
      await openViewer(page, { ...withMenu, n: width > height ? 3 : 4 });
      await expect(technique).toBeHidden();
    }
    await page.getByRole('button', { name: 'Farol: ' }).tap();
    await expect(technique).toBeVisible();
  });
});

own.describe('in Spanish', () => {
  own.use({ locale: 'es-MX' });
  own('the page is in the browser’s language, and another one is kept once it is chosen @verify', async ({ page }) => {
    await openViewer(page, { ...withMenu, technique: 'deferred' });
    await expect(page.locator('html')).toHaveAttribute('lang', 'es');
    await expect(page.getByLabel('Técnica').locator('option')).toContainText(['Automático', 'Forward, varias pasadas']);
    await expect(page.locator('.statistics')).toContainText('Técnica: Sombreado diferido');
    await page.getByLabel('Idioma').selectOption('English');
    await expect(page.getByLabel('Technique')).toBeVisible();
    await expect(page.locator('html')).toHaveAttribute('lang', 'en');
    await expect(page.getByRole('button', { name: 'Help' })).toHaveCount(1);
    await page.reload();
    await expect(page.getByLabel('Technique')).toBeVisible();
  });
});
