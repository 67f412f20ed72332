import { checkAgreement } from '../support/agreement';
import { compareImages, isFlat } from '../support/images';
import { expect, test } from '../support/test';
import { openViewer, readImage, still } from '../support/viewer';

/** Kinds of light that an engine scene may have, with the share of its intensity that keeps the picture exposed. */
const kinds = { point: 1, spot: 1, directional: 0.02, hemisphere: 0.02, ambient: 0.02 };
/** Of surfaces at one depth stock three shows the last drawn; one pass a light adds light to the first. */
const exceptions: Record<string, { largest: number } | undefined> = { 'dragons, forward': { largest: 1e-3 } };
const few = { lights: 8, n: 3, m: 3, resolution: 2 };

/**
 * Every scene by every technique under each kind of light, against stock three in linear float. Names come from the
 * page's registries, so that a new scene or technique is in. Inferred lighting has its buffers at full resolution. Two tests share the scenes, for two workers.
 */
for (const half of [0, 1]) {
  test(`every scene under each kind of light, ${half === 0 ? 'first' : 'second'} half`, async ({ page }) => {
    test.setTimeout(300_000);
    await openViewer(page, { ...still, width: 96, height: 54 });
    // at half of so few pixels lighting has nothing to go by; what half costs, agreement.spec.ts says
    await page.evaluate(() => void (window.viewer.farol.inferredScale = 1));
    const { scenes, techniques } = await page.evaluate(() => {
      const { scenes, techniques } = window.viewer.known;
      return { scenes: Object.keys(scenes), techniques: [...techniques] };
    });
    expect(scenes.length * techniques.length).toBeGreaterThan(0);
    for (const scene of scenes.filter((_, index) => index % 2 !== half)) {
      const intensities = await page.evaluate(
        async ([name, few]) => {
          const { parameters } = window.viewer.known.scenes[name];
          const values = Object.entries(few).filter(([parameter]) => parameter in parameters);
          await window.viewer.loadScene(name, Object.fromEntries(values));
          return window.viewer.engineScene.lights.map(({ intensity }) => intensity);
        },
        [scene, few] as const,
      );
      expect(intensities.length, `lights of ${scene}`).toBeGreaterThan(0);
      for (const [kind, scale] of Object.entries(kinds)) {
        await page.evaluate(
          ([kind, scale, intensities]) => {
            const { lights } = window.viewer.engineScene;
            lights.forEach((light, index) => {
              light.enabled = index < 8;
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
          [kind, scale, intensities] as const,
        );
        const stock = await readImage(page, 'three');
        expect(isFlat(stock), `${scene} under ${kind} lights, by stock three, shows one colour`).toBe(false);
        for (const technique of techniques) {
          // past the viewer, which would draw to the canvas too
          await page.evaluate((name) => void (window.viewer.farol.technique = name as 'auto'), technique);
          const family = technique === 'inferred' ? 'light-prepass' : technique;
          const name = `${scene}, ${kind}, ${technique}`;
          checkAgreement(
            family,
            compareImages(stock, await readImage(page)),
            name,
            exceptions[`${scene}, ${technique}`],
          );
        }
      }
    }
  });
}
