import { budgetOf } from './budgets';
import { expect, test } from './perfTest';

const LIGHTS = 1000;

test('nothing is sent while nothing moves, and little when one light does', async ({ page }) => {
  const measured = await page.evaluate((lights) => {
    const { perf } = window;
    return perf.techniques.map((technique) => {
      const world = perf.world(technique, { objects: 4, lights });
      const { info } = world.farol;
      const sent = (change: () => void) => {
        change();
        const { uploadBytes } = world.count();
        return { counted: uploadBytes, told: info.uploadBytes };
      };
      world.draw();
      const still = [sent(() => {}), sent(() => {})];
      const light = world.lights[lights >> 1];
      const one = sent(() => void (light.position.x += 0.01));
      const after = sent(() => {});
      const all = sent(() => world.lights.forEach(({ position }) => void (position.x += 0.01)));
      world.dispose();
      return { technique, drawn: info.technique, still, one, after, all };
    });
  }, LIGHTS);

  for (const { technique, drawn, still, one, after, all } of measured) {
    const { listsOfOne, listsOfAll } = budgetOf(drawn);
    for (const frame of [...still, after]) expect(frame, `${technique}: still`).toEqual({ counted: 0, told: 0 });
    expect(one.counted, `${technique}: one light moves; WebGL’s count and Farol’s`).toBe(one.told);
    expect(all.counted, `${technique}: all lights move; WebGL’s count and Farol’s`).toBe(all.told);
    // the row of the light table with its record, 256 records of 64 bytes, and that of its bounds, 256 of 16
    expect(one.counted, `${technique}: one light moves`).toBeLessThanOrEqual(256 * (64 + 16) + listsOfOne);
    expect(one.counted, `${technique}: one light moves`).toBeGreaterThan(0);
    const rows = Math.ceil((LIGHTS + 1) / 256);
    expect(all.counted, `${technique}: all lights move`).toBeLessThanOrEqual(rows * 256 * (64 + 16) + listsOfAll);
    expect(all.counted, `${technique}: all lights move`).toBeGreaterThanOrEqual(LIGHTS * 16);
  }
});
