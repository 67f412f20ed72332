import type { Page } from '@playwright/test';
import { allocatedWarm, KEPT, kept, least, LOOKS } from './heap';
import { expect, test } from './perfTest';

/** Lights of the fields that are compared. */
const FEW = 128;
const MANY = 8192;
/** Bytes a frame that the field as a whole may allocate: numbers that V8 puts on the heap to pass them to WebGL, 12 each. */
const OF_A_FIELD = 1200;
/** Bytes that differ between two counts of the same frames. */
const NOISE = 400;

/** Makes a world with a field all of whose lights move in each frame, its draws doing nothing, until its code is warm. @returns lights drawn */
async function prepare(page: Page, technique: string, fieldLights: number): Promise<number> {
  return page.evaluate(
    async ([technique, fieldLights]) => {
      const { perf } = window;
      const world = perf.world(technique as 'forward', { lights: 4, fieldLights, width: 32, height: 32 });
      // the code of fields is fetched on demand
      await window.testPage.farol.FarolRenderer.preload();
      world.draw();
      perf.drawNothing();
      const { field } = world;
      let frame = 0;
      window.perfFrames = function perfFrames(count) {
        for (let i = 0; i < count; i++) {
          frame++;
          if (field !== null) {
            const { array } = field.spheres;
            for (let k = 0; k < field.count; k++) array[4 * k] += frame % 2 ? 0.01 : -0.01;
            field.spheres.update();
          }
          world.draw();
        }
      };
      window.perfFrames(300);
      return world.farol.info.lights.total;
    },
    [technique, fieldLights] as const,
  );
}

// one of each way in which lights reach surfaces
for (const technique of ['forward', 'deferred', 'tiled-deferred', 'clustered-forward']) {
  test(`a frame with a field that moves allocates nothing for its lights, and keeps nothing: ${technique} @verify`, async ({
    page,
  }) => {
    test.setTimeout(180_000);
    const session = await page.context().newCDPSession(page);
    await session.send('HeapProfiler.enable');
    await prepare(page, technique, 0);
    const without = await allocatedWarm(page, session);
    expect(await prepare(page, technique, FEW)).toBe(4 + 1 + FEW);
    const few = await allocatedWarm(page, session, without + OF_A_FIELD);
    expect(await prepare(page, technique, MANY)).toBe(4 + 1 + MANY);
    const many = await allocatedWarm(page, session, few + NOISE);
    const left = await least(LOOKS, KEPT, () => kept(page, session));
    const seen =
      `${technique}: ${without.toFixed(0)} bytes a frame without a field, ${few.toFixed(0)} with ${FEW} lights, ` +
      `${many.toFixed(0)} with ${MANY}, ${left.toFixed(1)} kept`;
    test.info().annotations.push({ type: 'allocations', description: seen });
    expect(without, `the profiler sees what is allocated; ${seen}`).toBeGreaterThan(0);
    expect(few - without, seen).toBeLessThanOrEqual(OF_A_FIELD);
    expect(many - few, seen).toBeLessThanOrEqual(NOISE);
    expect(left, seen).toBeLessThanOrEqual(KEPT);
  });
}
