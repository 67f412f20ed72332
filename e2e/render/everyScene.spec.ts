import type { Page } from '@playwright/test';
import type { Light } from '@farol/engine';
import { byExtent } from '@farol/tools/extent';
import { checkAgreement } from '../support/agreement';
import { compareImages, type FloatImage, isFlat } from '../support/images';
import { inTurn, parts } from '../support/parts';
import { expect, test, type Watch } from '../support/test';
import { openViewer, readImage, still } from '../support/viewer';

/** Views that are rightly one colour where a scene has nothing of the kind: no glow, no metal, one roughness. */
const mayBeFlat = new Set(['emissive', 'metalness', 'roughness']);

/** Views that each technique draws in its own way; the others show the surface, the same whatever the technique. */
const ofTechnique = new Set(['final', 'lighting', 'light-count', 'overdraw', 'grid']);

/** Kinds of light that an engine scene may have, with the share of its intensity that keeps the picture exposed. */
const kinds = { point: 1, spot: 1, directional: 0.02, hemisphere: 0.02, ambient: 0.02 };
/** Number of lights of a scene that shine when it is compared with stock three, which has each in the text of its shaders. */
const COMPARED_LIGHTS = byExtent({ slice: 4, verify: 8 });
/** Limits of scenes with surfaces at one depth: stock three shows the last one drawn, one pass a light lights the first. */
const exceptions: Record<string, { largest: number } | undefined> = { 'dragons, forward': { largest: 1e-3 } };

/** Size of the picture (pixels). */
const WIDTH = 96;
const HEIGHT = 54;

/** In the slice a technique has its turn in one scene of so many: as many as there are techniques, one a scene. */
const SCENES = 11;

/** Few lights and objects, of the scenes that let one choose. */
const few = { lights: 12, n: 4, m: 4 };

/** Gives the intensities of the scene's lights. */
const load = (page: Page, scene: string): Promise<number[]> =>
  page.evaluate(
    async ([name, few]) => {
      const { parameters } = window.viewer.known.scenes[name];
      const values = Object.entries(few).filter(([parameter]) => parameter in parameters);
      await window.viewer.loadScene(name, Object.fromEntries(values));
      return window.viewer.engineScene.componentsOf<Light>('Light').map(({ intensity }) => intensity);
    },
    [scene, few] as const,
  );

/** Reads a view as the current technique draws it to a float target: past the viewer, which would draw to the canvas too. */
async function readView(page: Page, view: string): Promise<FloatImage> {
  await page.evaluate((name) => void (window.viewer.farol.view = name as 'final'), view);
  const image = await readImage(page);
  expect(image.width * image.height, 'pixels').toBe(WIDTH * HEIGHT);
  return image;
}

/**
 * Every technique draws something in every view, views by turns, without a word from the console. The views of surfaces are
 * those of `deferred`: they are drawn by one pass, from a G-buffer of its own, whatever the technique.
 */
async function checkViews(page: Page, watch: Watch, scene: string, index: number): Promise<void> {
  const { techniques, views } = await page.evaluate(() => {
    const { techniques, views } = window.viewer.known;
    // those after 'grid' show buffers of effects, see bufferViews.spec.ts
    return { techniques: [...techniques], views: views.slice(0, views.indexOf('grid') + 1) };
  });
  expect(techniques.length * views.length).toBeGreaterThan(0);
  const surfaces = views.filter((view) => !ofTechnique.has(view));
  const byDeferred = new Map<string, FloatImage>();
  const turns = inTurn([...techniques.entries()], index, SCENES);
  const compared = new Set(turns.map(([turn]) => surfaces[turn % surfaces.length]));
  await page.evaluate(() => window.viewer.setTechnique('deferred'));
  for (const view of compared) byDeferred.set(view, await readView(page, view));
  await page.evaluate(() => void (window.viewer.farol.view = 'final'));
  for (const [turn, technique] of turns) {
    const own = inTurn(
      views.filter((view) => ofTechnique.has(view) && view !== 'final'),
      index,
      4,
    );
    // to the canvas once, then each view to a float target
    await page.evaluate((name) => window.viewer.setTechnique(name), technique);
    const flat: string[] = [];
    for (const view of ['final', ...own, surfaces[turn % surfaces.length]]) {
      const image = await readView(page, view);
      const other = byDeferred.get(view);
      if (other !== undefined) {
        const { largest } = compareImages(other, image);
        expect.soft(largest, `${scene}: ${view} by ${technique}, beside deferred`).toBe(0);
      }
      if (isFlat(image) && !mayBeFlat.has(view)) flat.push(view);
      expect(watch.problems, `${scene}, ${technique}, ${view}`).toEqual([]);
    }
    expect(flat, `views of ${scene} by ${technique} that show one colour only, or NaN`).toEqual([]);
    await page.evaluate(() => void (window.viewer.farol.view = 'final'));
  }
}

/** Techniques draw kinds of light as stock three does, in linear float; both by turns in the slice. */
async function checkKinds(page: Page, scene: string, index: number, intensities: readonly number[]): Promise<void> {
  const known = await page.evaluate(() => [...window.viewer.known.techniques]);
  expect(intensities.length * known.length, `lights of ${scene}, techniques`).toBeGreaterThan(0);
  const all = Object.entries(kinds);
  for (const [kind, scale] of inTurn(all, index, all.length)) {
    await page.evaluate(
      ([kind, scale, intensities, count]) => {
        const lights = window.viewer.engineScene.componentsOf<Light>('Light');
        lights.forEach((light, index) => {
          light.enabled = index < count;
          // what three's lights have not, stock three cannot show
          Object.assign(light, {
            type: kind,
            attenuation: 'physical',
            ambient: [0, 0, 0],
            ownSpecular: false,
            exponent: 0,
          });
          light.intensity = intensities[index] * scale;
        });
      },
      [kind, scale, intensities, COMPARED_LIGHTS] as const,
    );
    const stock = await readImage(page, 'three');
    expect(isFlat(stock), `${scene} under ${kind} lights, by stock three, shows one colour`).toBe(false);
    for (const technique of inTurn(known, index, SCENES)) {
      // past the viewer, which would draw to the canvas too
      await page.evaluate((name) => void (window.viewer.farol.technique = name as 'auto'), technique);
      const family = technique === 'inferred' ? 'light-prepass' : technique;
      const name = `${scene}, ${kind}, ${technique}`;
      checkAgreement(family, compareImages(stock, await readImage(page)), name, exceptions[`${scene}, ${technique}`]);
    }
  }
}

/**
 * Every scene by every technique: each view, then each kind of light, by turns in `npm test`. The names are read from the page's registries, so
 * that a new scene, technique or view is in. Two tests share the scenes, for two workers; more where there are more.
 */
const SHARES = [0, 1, 2, 3, 4, 5];
for (const [part, shares] of parts(SHARES, 2).entries()) {
  test(`every scene by every technique, in every view and under each kind of light, part ${part + 1}`, async ({
    page,
    watch,
  }) => {
    test.setTimeout(480_000);
    await openViewer(page, { ...still, width: WIDTH, height: HEIGHT });
    const { scenes, inferredScale } = await page.evaluate(() => ({
      scenes: Object.keys(window.viewer.known.scenes),
      inferredScale: window.viewer.farol.inferredScale,
    }));
    expect(scenes.length).toBeGreaterThan(1);
    for (const [index, scene] of scenes.entries()) {
      if (!shares.includes(index % SHARES.length)) continue;
      const intensities = await load(page, scene);
      await checkViews(page, watch, scene, index);
      // at half of so few pixels lighting has nothing to go by; what half costs, agreement.spec.ts says
      await page.evaluate(() => void (window.viewer.farol.inferredScale = 1));
      await checkKinds(page, scene, index, intensities);
      await page.evaluate((scale) => void (window.viewer.farol.inferredScale = scale), inferredScale);
    }
  });
}
