import { budgetOf } from './budgets';
import { expect, test } from './perfTest';

const LIGHTS = 1000;
/** Bytes of a record of the light table. */
const RECORD = 64;
/** Records of a row of it, which is what is sent at least when several rows changed. */
const RECORDS = 256;
const ROW = RECORDS * RECORD;

test('nothing is sent while nothing moves, and little when one light does', async ({ page }) => {
  const measured = await page.evaluate((lights) => {
    const { perf } = window;
    perf.drawNothing(); // what is sent and held does not hang on it
    return perf.techniques.map((technique) => {
      const world = perf.world(technique, { objects: 4, lights });
      const { info } = world.farol;
      const frame = (change: () => void) => {
        change();
        const { uploadBytes } = world.count();
        return { counted: uploadBytes, told: info.uploadBytes };
      };
      const move = (light: (typeof world.lights)[number]) => void (light.position.x += 0.001);
      // light data may take turns between textures, so that each change is sent again in the frames after it
      const sent = (change: () => void) => [1, 2, 3, 4].map(() => frame(change))[3];
      sent(() => world.lights.forEach(move));
      const one = sent(() => move(world.lights[lights >> 1]));
      const still = [frame(() => {}), frame(() => {})];
      const all = sent(() => world.lights.forEach(move));
      world.dispose();
      return { technique, drawn: info.technique, still, one, all };
    });
  }, LIGHTS);

  for (const { technique, drawn, still, one, all } of measured) {
    const { listsOfOne, listsOfAll } = budgetOf(drawn);
    for (const frame of still) expect(frame, `${technique}: still`).toEqual({ counted: 0, told: 0 });
    expect(one.counted, `${technique}: one light moves; WebGL’s count and Farol’s`).toBe(one.told);
    expect(all.counted, `${technique}: all lights move; WebGL’s count and Farol’s`).toBe(all.told);
    expect(one.counted, `${technique}: one light moves`).toBeLessThanOrEqual(RECORD + listsOfOne);
    expect(one.counted, `${technique}: one light moves`).toBeGreaterThan(0);
    const rows = Math.ceil((LIGHTS + 1) / RECORDS);
    expect(all.counted, `${technique}: all lights move`).toBeLessThanOrEqual(rows * ROW + listsOfAll);
    expect(all.counted, `${technique}: all lights move`).toBeGreaterThanOrEqual(LIGHTS * 16);
  }
});
