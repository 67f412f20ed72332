import { expect, test } from '../support/benchTest';

/**
 * Draws both eyes to targets of 8 bits in linear light and adds their channels up, by weights of 1.2 in all: where a channel
 * is rounded to the next step, it is off by as much, which in the dark is up to 13 steps of the canvas's.
 */
const OF_LINEAR_BYTES = 'AnaglyphEffect';
/** A step and its weights, and the canvas's own rounding (linear). */
const LINEAR_STEPS = 2 / 255;

test('what three’s addons draw, and what draws by them, is as by stock three, by each kind of technique', async ({
  benchPage: page,
}) => {
  const results = await page.evaluate(async () => {
    const { addonCases, alphaBench, compareImages, isFlat, techniqueInTurn } = window.testPage;
    const { addonCases: cases, addonScene } = await addonCases();
    const { bench, toCanvas } = alphaBench(96, 64);
    const { webgl, farol } = bench;
    const render = farol.render.bind(farol);
    const farolInPlace = new Proxy(webgl, {
      get: (one, name) => (name === 'render' ? render : Reflect.get(one, name)),
    });
    const linearOf = (c: number) => (c <= 0.04045 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4);
    const decoded = (image: ReturnType<typeof toCanvas>) => ({ ...image, data: Array.from(image.data, linearOf) });
    const techniques = ['forward-plus', 'deferred', 'forward', 'light-prepass'] as const;
    return Object.keys(cases).flatMap((name, i) => {
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
      return techniqueInTurn(i, techniques).map((technique) => {
        farol.technique = technique;
        draw(farolInPlace);
        const drawn = draw(farolInPlace);
        const { largest: linear } = compareImages(decoded(stock), decoded(drawn));
        return { name, technique, flat: isFlat(stock), ...compareImages(stock, drawn), linear };
      });
    });
  });
  for (const { name, technique, flat, linear, psnr, share, alpha } of results) {
    expect(flat, `${name}: stock picture is flat`).toBe(false);
    if (name === OF_LINEAR_BYTES) expect.soft(linear, `${name}, ${technique}`).toBeLessThan(LINEAR_STEPS);
    else {
      expect.soft(psnr, `${name}, ${technique}`).toBeGreaterThan(55); // of 8 bits
      expect.soft(share, `${name}, ${technique}`).toBeLessThan(0.001);
    }
    expect.soft(alpha, `${name}, ${technique}: alpha`).toBe(0);
  }
});
