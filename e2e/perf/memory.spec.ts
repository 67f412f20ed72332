import { budgetOf } from './budgets';
import { expect, test } from './perfTest';

test('targets take no more a pixel than each technique may, are told truly, and go with dispose', async ({ page }) => {
  const measured = await page.evaluate(() => {
    const { perf } = window;
    perf.drawNothing(); // what is sent and held does not hang on it
    const [width, height] = [160, 90];
    perf.world('forward-single-pass', { width, height }).draw(); // what three itself makes once
    return perf.techniques.map((technique) => {
      const before = perf.textureBytes();
      const world = perf.world(technique, { objects: 4, lights: 1000, width, height });
      const { info } = world.farol;
      // light data may take turns between textures: lights that move bring all of them out
      const draw = () => {
        for (let i = 0; i < 4; i++) {
          for (const light of world.lights) light.position.x += 0.001;
          world.draw();
        }
      };
      draw();
      const small = { counted: perf.textureBytes() - before, told: info.targetBytes, drawn: info.technique };
      world.setSize(2 * width, 2 * height);
      draw();
      const large = { counted: perf.textureBytes() - before, told: info.targetBytes, drawn: info.technique };
      world.dispose();
      const pixels = 3 * width * height;
      const left = perf.textureBytes() - before;
      return { technique, small, large, pixels, left };
    });
  });
  for (const { technique, small, large, pixels, left } of measured) {
    const perPixel = (large.counted - small.counted) / pixels;
    const seen = `${technique}: ${perPixel.toFixed(2)} bytes a pixel`;
    test.info().annotations.push({ type: 'memory', description: `${seen}, ${small.told} at 160 × 90` });
    // auto may pick another technique for another size
    if (small.drawn === large.drawn) expect(perPixel, seen).toBeLessThanOrEqual(budgetOf(small.drawn).bytesPerPixel);
    // room that is set aside and not drawn to yet may be told, but nothing may be kept quiet
    expect(small.told, `${technique}: bytes that Farol tells of`).toBeGreaterThanOrEqual(small.counted);
    expect(small.told, `${technique}: bytes that Farol tells of`).toBeLessThanOrEqual(1.3 * small.counted);
    expect(left, `${technique}: bytes left after dispose`).toBe(0);
  }
});
