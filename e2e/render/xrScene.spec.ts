import type { App, GameObject } from '@farol/engine';
import type { Page } from '@playwright/test';
import { expect, test } from '../support/test';

test.use({ viewport: { width: 192, height: 96 } });

declare global {
  interface Window {
    inXR: { app: App; rig: GameObject; box: GameObject; errors: string[] };
  }
}

/** Opens a scene with an XRRig and a Grabbable, and enters a session by its button. */
async function enter(page: Page, pagesURL: string): Promise<void> {
  await open(page, pagesURL);
  await page.getByRole('button', { name: 'Enter VR' }).dispatchEvent('click');
  await page.waitForFunction(() => window.inXR.app.webgl.xr.isPresenting);
  await page.waitForFunction(() => window.inXR.app.renderer.info.technique === 'clustered-forward');
}

/** Opens the scene and waits for its buttons. */
async function open(page: Page, pagesURL: string): Promise<void> {
  await page.goto(`${pagesURL}xr.html`);
  await page.waitForFunction(() => 'xrPage' in window);
  await page.evaluate(async () => {
    const { device } = window.xrPage;
    const { App, Camera, GameObject, Grabbable, Light, ObjectRenderer, XRRig } = await window.xrPage.engine();
    const { addXRButtons, stageOf } = await window.xrPage.engineXR();
    const app = new App({ parent: document.body });
    const { scene } = app;
    const add = (name: string, position: [number, number, number]) => {
      const object = new GameObject(name);
      object.transform.set('position', position);
      scene.add(object);
      return object;
    };
    const floor = add('floor', [0, -0.5, 0]);
    floor.transform.set('scale', [20, 1, 20]);
    floor.addComponent(ObjectRenderer, { mesh: 'box' });
    const box = add('box', [0.2, 1.2, -0.5]);
    box.transform.set('scale', [0.2, 0.2, 0.2]);
    box.addComponent(ObjectRenderer, { mesh: 'box' });
    box.addComponent(Grabbable);
    add('lamp', [0, 3, 0]).addComponent(Light, { type: 'point', range: 20 });
    const rig = add('rig', [0, 0, 0]);
    rig.addComponent(XRRig, { speed: 4 });
    add('camera', [0, 1.6, 2]).addComponent(Camera);
    const errors: string[] = [];
    window.inXR = { app, rig, box, errors };
    device.position.set(0, 1.6, 0);
    device.controllers.right!.position.set(0.2, 1.2, -0.4);
    app.start();
    const labels = { 'immersive-vr': 'Enter VR', 'immersive-ar': 'Enter AR' };
    await addXRButtons(
      document.body,
      labels,
      () => stageOf(app),
      ({ message }) => errors.push(message),
    );
  });
  await expect(page.getByRole('button')).toHaveText(['Enter VR', 'Enter AR']);
}

const rigPlace = (page: Page) => page.evaluate(() => window.inXR.rig.object3D.position.toArray());
const stick = (page: Page, hand: 'left' | 'right', x: number, y: number) =>
  page.evaluate(
    ([hand, x, y]) =>
      window.xrPage.device.controllers[hand as 'left']!.updateAxes('thumbstick', x as number, y as number),
    [hand, x, y],
  );

test('sticks walk, turn by steps and teleport; the session ends as it began', async ({ page, pagesURL }) => {
  await enter(page, pagesURL);

  await stick(page, 'left', 0, -1);
  await expect.poll(async () => (await rigPlace(page))[2]).toBeLessThan(-0.5);
  await stick(page, 'left', 0, 0);

  await stick(page, 'right', 1, 0);
  const yaw = () => page.evaluate(() => 2 * Math.asin(window.inXR.rig.object3D.quaternion.y));
  await expect.poll(yaw).toBeCloseTo(-Math.PI / 6, 5);
  // once a push, however long
  const turned = await rigPlace(page);
  await stick(page, 'left', 0, -1);
  await expect.poll(async () => (await rigPlace(page))[2]).toBeLessThan(turned[2] - 0.3);
  await stick(page, 'left', 0, 0);
  expect(await yaw()).toBeCloseTo(-Math.PI / 6, 5);
  await stick(page, 'right', 0, 0);
  await expect.poll(() => page.evaluate(() => window.xrPage.device.controllers.right!.getAxes('thumbstick').x)).toBe(0);

  // the right hand points down to the floor before it
  await page.evaluate(() => {
    const { right } = window.xrPage.device.controllers;
    right!.quaternion.set(-Math.sin(Math.PI / 8), 0, 0, Math.cos(Math.PI / 8));
  });
  const before = await rigPlace(page);
  await stick(page, 'right', 0, -1);
  const marked = () => page.evaluate(() => window.inXR.app.scene.three.children.some(({ type }) => type === 'Mesh'));
  await expect.poll(marked).toBe(true);
  expect(await rigPlace(page)).toEqual(before);
  await stick(page, 'right', 0, 0);
  await expect.poll(marked).toBe(false);
  const after = await rigPlace(page);
  expect(Math.hypot(after[0] - before[0], after[2] - before[2])).toBeGreaterThan(1);
  expect(after[1]).toBeCloseTo(0, 5);

  await page.evaluate(() => window.inXR.app.webgl.xr.getSession()!.end());
  await page.waitForFunction(() => window.inXR.app.running);
  const left = await page.evaluate(() => {
    const { app, errors, rig } = window.inXR;
    return { enabled: app.webgl.xr.enabled, children: rig.object3D.children.length, errors };
  });
  expect(left).toEqual({ enabled: false, children: 0, errors: [] });
});

test('a hand takes what is near, carries it and lets go of it', async ({ page, pagesURL }) => {
  await enter(page, pagesURL);
  const place = () => page.evaluate(() => window.inXR.box.object3D.position.toArray());
  // until a frame of the session has seen it
  const squeeze = (value: 0 | 1) =>
    page.evaluate(async (value) => {
      const session = window.inXR.app.webgl.xr.getSession()!;
      const seen = new Promise((resolve) => {
        session.addEventListener(value === 1 ? 'squeezestart' : 'squeezeend', resolve, { once: true });
      });
      window.xrPage.device.controllers.right!.updateButtonValue('squeeze', value);
      await seen;
    }, value);
  const moveHand = (x: number, y: number, z: number) =>
    page.evaluate((to) => window.xrPage.device.controllers.right!.position.set(...to), [x, y, z] as const);
  const start = await place();
  await moveHand(0.2, 1.2, -0.35);
  await squeeze(1);
  await moveHand(0.7, 1.5, -0.35);
  await expect.poll(async () => (await place())[0]).toBeGreaterThan(start[0] + 0.3);
  await squeeze(0);
  const held = await place();
  await moveHand(0.2, 1.2, -0.35);
  await stick(page, 'left', 0, 1);
  await expect.poll(async () => (await rigPlace(page))[2]).toBeGreaterThan(0.3);
  expect(await place()).toEqual(held);
});

test('a session shows the scene that takes the place of its first one, and ends with the App @verify', async ({
  page,
  pagesURL,
}) => {
  await enter(page, pagesURL);
  await page.evaluate(async () => {
    const { GameObject, Scene, XRRig } = await window.xrPage.engine();
    const { app } = window.inXR;
    const scene = new Scene();
    const rig = new GameObject('rig');
    scene.add(rig);
    rig.addComponent(XRRig, {});
    app.scene.dispose();
    app.scene = scene;
    window.inXR.rig = rig;
  });
  await stick(page, 'left', 0, -1);
  await expect.poll(async () => (await rigPlace(page))[2]).toBeLessThan(-0.2);
  await page.evaluate(() => window.inXR.app.dispose());
  await expect.poll(() => page.evaluate(() => window.inXR.app.webgl.xr.isPresenting)).toBe(false);
  const left = await page.evaluate(() => [window.inXR.app.running, window.inXR.rig.object3D.children.length]);
  expect(left).toEqual([false, 0]);
});

test('a session that cannot draw ends, with the reason, and the page goes on @verify', async ({ page, pagesURL }) => {
  await open(page, pagesURL);
  await page.evaluate(() => {
    const gl = window.inXR.app.webgl.getContext() as WebGL2RenderingContext;
    gl.makeXRCompatible = () => Promise.reject(new Error('no headset at this GPU'));
  });
  await page.getByRole('button', { name: 'Enter VR' }).dispatchEvent('click');
  await expect.poll(() => page.evaluate(() => window.inXR.errors)).toEqual(['no headset at this GPU']);
  const after = await page.evaluate(() => [window.inXR.app.running, window.inXR.app.webgl.xr.enabled]);
  expect(after).toEqual([true, false]);
});
