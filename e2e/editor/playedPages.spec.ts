import { pathToFileURL } from 'node:url';
import type { BrowserContext, Page } from '@playwright/test';
import type { Object3D, Scene } from 'three';
import { expect, test } from '../support/test';
import { openEditor } from './editor';

test.use({ viewport: { width: 900, height: 640 }, reducedMotion: 'reduce' });

/** Steps of a sixtieth of a second that are compared, from the first that moves a body on. */
const STEPS = 60;

/** Name of an object, its position (m) and rotation (quaternion). */
type Placed = readonly [string, ...number[]];

declare global {
  interface Window {
    /** Frames since a body moved first, -1 before, and what is in the scene after them. */
    played: { steps: number; places: readonly Placed[] };
  }
}

/** Objects of a scene with their places; this function runs in the pages. */
function placesIn(scene: Object3D): Placed[] {
  const places: Placed[] = [];
  scene.traverse((object) => {
    const { name, position, quaternion } = object;
    places.push([name, ...position.toArray(), ...quaternion.toArray()]);
  });
  return places;
}

/** Steps the scene of the editor, and puts it back. */
const playInEditor = (page: Page): Promise<readonly Placed[]> =>
  page.evaluate(
    async ([source, steps]) => {
      const places = new Function(`return (${source})`)() as typeof placesIn;
      const { scene, simulation } = window.editor.document;
      const height = (): number => scene.find('Ball')!.object3D.position.y;
      const still = height();
      while (height() === still) {
        simulation.step();
        // the physics are fetched late
        await new Promise(requestAnimationFrame);
      }
      for (let i = 0; i < steps; i++) simulation.step();
      const found = places(scene.three);
      simulation.stop();
      return found;
    },
    [String(placesIn), STEPS] as const,
  );

/** Makes the frames of a page a sixtieth of a second apart, and stops once the steps are played. Runs first in the page. */
function playSteps([source, steps]: readonly [string, number]): void {
  const places = new Function(`return (${source})`)() as typeof placesIn;
  const scenes: Scene[] = [];
  // three tells its tools of each scene
  const tools = new EventTarget();
  tools.addEventListener('observe', (event) => {
    const { detail } = event as CustomEvent<Scene>;
    if (detail.isScene) scenes.push(detail);
  });
  Object.assign(window, { __THREE_DEVTOOLS__: tools, played: { steps: -1, places: [] } });
  const request = window.requestAnimationFrame.bind(window);
  let time = 0;
  let still: number | null = null;
  window.requestAnimationFrame = (callback) =>
    request(() => {
      const { played } = window;
      if (played.steps === steps) return;
      callback((time += 1000 / 60));
      const scene = scenes.find(({ name }) => name === document.title);
      const height = scene?.getObjectByName('Ball')?.position.y ?? null;
      still ??= height;
      if (scene && height !== still) window.played = { steps: played.steps + 1, places: places(scene) };
    });
}

async function playFromDisk(context: BrowserContext, html: string): Promise<readonly Placed[]> {
  const page = await context.newPage();
  const problems: string[] = [];
  page.on('pageerror', (error) => problems.push(error.message));
  page.on('console', (message) => message.type() === 'error' && problems.push(message.text()));
  await page.setViewportSize({ width: 200, height: 120 });
  await page.addInitScript(playSteps, [String(placesIn), STEPS] as const);
  await page.goto(pathToFileURL(html).href);
  await expect
    .poll(async () => [await page.evaluate(() => window.played.steps), problems], { timeout: 120_000 })
    .toEqual([STEPS, []]);
  const { places } = await page.evaluate(() => window.played);
  await page.close();
  return places;
}

test('the sample of physics with a fire, as a web page from a disk, plays as in the editor @verify', async ({
  page,
  context,
}, info) => {
  await openEditor(page, 'empty');
  await page.evaluate(async () => {
    // what is asked for is where things are
    window.editor.viewport.renderNow = () => {};
    await window.editor.openSample('physics');
    window.editor.document.scene.find('Crane')!.addComponent('ParticleEmitter');
  });
  await page.keyboard.press('Control+Shift+E');
  const download = page.waitForEvent('download');
  await page.getByRole('button', { name: 'Web page…' }).click();
  const html = info.outputPath('physics.html');
  await (await download).saveAs(html);
  await page.getByRole('button', { name: 'Close', exact: true }).click();
  const inEditor = await playInEditor(page);
  const fromDisk = await playFromDisk(context, html);
  expect(fromDisk.map(([name]) => name)).toEqual(inEditor.map(([name]) => name));
  for (const [i, [name, ...numbers]] of inEditor.entries())
    for (const [k, value] of numbers.entries()) expect(fromDisk[i][k + 1], `${name}, ${k}`).toBeCloseTo(value, 9);
});
