import type { Page } from '@playwright/test';
import { budgetOf } from './budgets';
import { allocated, KEPT, kept, least, LOOKS } from './heap';
import { expect, test } from './perfTest';

/** Makes a world whose lights move, its draws doing nothing, and draws it until its code is warm. */
async function prepare(page: Page, technique: string, lights: number, objects: number): Promise<string> {
  return page.evaluate(
    ([technique, lights, objects]) => {
      const { perf } = window;
      const size = { width: 32, height: 32 };
      const world = perf.world(technique as 'forward', { lights, objects, spots: lights / 4, ...size });
      world.draw();
      perf.drawNothing();
      const places = Float64Array.from(world.lights, (light) => light.position.x);
      let frame = 0;
      window.perfFrames = function perfFrames(count) {
        for (let i = 0; i < count; i++) {
          frame++;
          for (let k = 0; k < places.length; k++) world.lights[k].position.x = places[k] + 0.01 * (frame % 7);
          world.draw();
        }
      };
      window.perfFrames(300);
      return world.farol.info.technique;
    },
    [technique, lights, objects] as const,
  );
}

test.describe.configure({ mode: 'parallel' });

/** Tests that share the techniques, and whether they ask for what a frame keeps, which hangs on the garbage collector. */
const shares = {
  'by one of each family': {
    has: (technique: string) => /^(clustered-forward|deferred)$/.test(technique),
    asks: false,
  },
  'and keeps nothing, half 1 @verify': { has: (_: string, index: number) => index % 2 === 0, asks: true },
  'and keeps nothing, half 2 @verify': { has: (_: string, index: number) => index % 2 === 1, asks: true },
};

for (const [title, { has, asks }] of Object.entries(shares)) {
  test(`a frame allocates no more than it may for each light and object, ${title}`, async ({ page }) => {
    test.setTimeout(180_000);
    const session = await page.context().newCDPSession(page);
    await session.send('HeapProfiler.enable');
    const look = () => allocated(page, session);
    const techniques = await page.evaluate(() => [...window.perf.techniques]);
    for (const technique of techniques.filter(has)) {
      const drawn = await prepare(page, technique, 100, 20);
      const { garbageOfLight } = budgetOf(drawn);
      const few = await least(3, 0, look);
      const left = asks ? await least(LOOKS, KEPT, () => kept(page, session)) : 0;

      await prepare(page, technique, 1000, 20);
      const perLight = ((await least(LOOKS, few + 900 * garbageOfLight, look)) - few) / 900;
      // 'auto' may draw more objects by another technique, which is then compared with itself
      const drawnMany = await prepare(page, technique, 100, 200);
      const { garbageOfObject } = budgetOf(drawnMany);
      let fewObjects = few;
      if (drawnMany !== drawn) {
        await prepare(page, drawnMany, 100, 20);
        fewObjects = await least(3, 0, look);
        await prepare(page, technique, 100, 200);
      }
      const perObject = ((await least(LOOKS, fewObjects + 180 * garbageOfObject, look)) - fewObjects) / 180;

      const seen =
        `${technique}: ${few.toFixed(0)} bytes a frame, ${perLight.toFixed(1)} more a light, ` +
        `${perObject.toFixed(1)} more an object, ${left.toFixed(1)} kept`;
      test.info().annotations.push({ type: 'allocations', description: seen });

      expect(few, `the profiler sees what is allocated; ${seen}`).toBeGreaterThan(0);
      expect(perLight, seen).toBeLessThanOrEqual(garbageOfLight);
      expect(perObject, seen).toBeLessThanOrEqual(garbageOfObject);
      expect(left, seen).toBeLessThanOrEqual(KEPT);
    }
  });
}
