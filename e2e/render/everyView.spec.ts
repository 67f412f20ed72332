import { isFlat } from '../support/images';
import { expect, test } from '../support/test';
import { openViewer, readImage, still } from '../support/viewer';

/** Views that are rightly one colour where a scene has nothing of the kind: no glow, no metal, one roughness. */
const mayBeFlat = new Set(['emissive', 'metalness', 'roughness']);

/** Views that each technique draws in its own way; the others show the surface, the same whatever the technique. */
const ofTechnique = new Set(['final', 'lighting', 'light-count', 'overdraw', 'grid']);

/** Of the picture (pixels). */
const WIDTH = 96;
const HEIGHT = 54;

/** Few lights and objects, of the scenes that let one choose. */
const few = { lights: 12, n: 4, m: 4 };

/**
 * Every scene by every technique draws something in every view, and without a word from the console; views of the surface
 * by the techniques in turn. The names are read
 * from the page's registries, so that a new scene, technique or view is in. Two tests share the scenes, for two workers.
 */
for (const half of [0, 1]) {
  test(`every technique and view draws every scene, ${half === 0 ? 'first' : 'second'} half`, async ({
    page,
    watch,
  }) => {
    test.setTimeout(240_000);
    await openViewer(page, { ...still, width: WIDTH, height: HEIGHT });
    const { scenes, techniques, views } = await page.evaluate(() => {
      const { scenes, techniques, views } = window.viewer.known;
      return { scenes: Object.keys(scenes), techniques: [...techniques], views: [...views] };
    });
    expect(scenes.length * techniques.length * views.length).toBeGreaterThan(0);
    for (const scene of scenes.filter((_, index) => index % 2 === half)) {
      await page.evaluate(
        ([name, few]) => {
          const { parameters } = window.viewer.known.scenes[name];
          const values = Object.entries(few).filter(([parameter]) => parameter in parameters);
          return window.viewer.loadScene(name, Object.fromEntries(values));
        },
        [scene, few] as const,
      );
      for (const [turn, technique] of techniques.entries()) {
        // To the canvas once, then each view to a float target; past the viewer, which would draw to the canvas too.
        await page.evaluate((name) => window.viewer.setTechnique(name), technique);
        const flat: string[] = [];
        const surfaces = views.filter((view) => !ofTechnique.has(view));
        for (const view of [...views.filter((view) => ofTechnique.has(view)), surfaces[turn % surfaces.length]]) {
          await page.evaluate((name) => void (window.viewer.farol.view = name as 'final'), view);
          const image = await readImage(page);
          expect(image.width * image.height, 'pixels').toBe(WIDTH * HEIGHT);
          if (isFlat(image) && !mayBeFlat.has(view)) flat.push(view);
          expect(watch.problems, `${scene}, ${technique}, ${view}`).toEqual([]);
        }
        expect(flat, `views of ${scene} by ${technique} that show one colour only, or NaN`).toEqual([]);
        await page.evaluate(() => void (window.viewer.farol.view = 'final'));
      }
    }
  });
}
