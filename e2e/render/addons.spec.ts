import { expect, test } from '../support/test';

/** Draws to targets of 8 bits in linear light, of which one step is up to 13 of the canvas's in the dark. */
const OF_LINEAR_BYTES = 'AnaglyphEffect';

test('what three’s addons draw, and what draws by them, is as by stock three, by each kind of technique', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(async () => {
    const { addonCases, alphaBench, compareImages, isFlat } = window.testPage;
    const { addonCases: cases, addonScene } = await addonCases();
    const { bench, toCanvas } = alphaBench(96, 64);
    const { webgl, farol } = bench;
    const render = farol.render.bind(farol);
    const farolInPlace = new Proxy(webgl, {
      get: (one, name) => (name === 'render' ? render : Reflect.get(one, name)),
    });
    return Object.keys(cases).flatMap((name) => {
      const { scene, camera, make } = addonScene(name, 96, 64);
      const draw = (renderer: typeof webgl) => {
        const drawScene = make?.(renderer) ?? (() => renderer.render(scene, camera));
        const image = toCanvas(() => drawScene(scene, camera));
        webgl.setScissorTest(false);
        webgl.setViewport(0, 0, 96, 64);
        webgl.autoClear = true;
        return image;
      };
      draw(webgl);
      const stock = draw(webgl);
      return (['forward', 'forward-plus', 'deferred', 'light-prepass'] as const).map((technique) => {
        farol.technique = technique;
        draw(farolInPlace);
        return { name, technique, flat: isFlat(stock), ...compareImages(stock, draw(farolInPlace)) };
      });
    });
  });
  for (const { name, technique, flat, psnr, share, alpha } of results) {
    expect(flat, `${name}: stock picture is flat`).toBe(false);
    expect.soft(psnr, `${name}, ${technique}`).toBeGreaterThan(55); // of 8 bits
    if (name !== OF_LINEAR_BYTES) expect.soft(share, `${name}, ${technique}`).toBeLessThan(0.001);
    expect.soft(alpha, `${name}, ${technique}: alpha`).toBe(0);
  }
});
