import type { CDPSession, Page } from '@playwright/test';
import { budgetOf } from './budgets';
import { expect, test } from './perfTest';

/** Frames of one look at the heap. */
const FRAMES = 50;
/** Looks until what is compiled late has been compiled. */
const LOOKS = 8;
/** Bytes that a frame may leave for good: less than the smallest object, which is what V8 itself adds meanwhile. */
const KEPT = 10;

interface ProfileNode {
  callFrame: { functionName: string };
  selfSize: number;
  children: ProfileNode[];
}

declare global {
  interface Window {
    perfFrames(count: number): void;
  }
}

/**
 * Bytes that JavaScript allocates in a frame whose lights move, collected or not: by V8's sampling heap profiler over FRAMES
 * frames, below the function that draws them. It samples every 256th byte on average and scales up, so 50 frames of 10 kB
 * are known to about 2%. What V8 allocates to compile is not in it.
 */
async function allocated(page: Page, session: CDPSession): Promise<number> {
  await session.send('HeapProfiler.startSampling', {
    samplingInterval: 256,
    includeObjectsCollectedByMajorGC: true,
    includeObjectsCollectedByMinorGC: true,
  });
  await page.evaluate((frames) => window.perfFrames(frames), FRAMES);
  const { profile } = (await session.send('HeapProfiler.stopSampling')) as { profile: { head: ProfileNode } };
  const size = (node: ProfileNode): number => node.children.reduce((sum, child) => sum + size(child), node.selfSize);
  const inFrames = (node: ProfileNode): number =>
    node.callFrame.functionName === 'perfFrames'
      ? size(node)
      : node.children.reduce((sum, child) => sum + inFrames(child), 0);
  return inFrames(profile.head) / FRAMES;
}

/** Bytes by which the heap, its garbage collected, is larger after a frame than before: over 1,000 frames. */
async function kept(page: Page, session: CDPSession): Promise<number> {
  const frames = 1000;
  const used = async () => {
    await session.send('HeapProfiler.collectGarbage');
    return (await session.send('Runtime.getHeapUsage')).usedSize;
  };
  const before = await used();
  await page.evaluate((frames) => window.perfFrames(frames), frames);
  return ((await used()) - before) / frames;
}

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

/** The least of some looks; no more looks than it takes to come to `enough`. */
async function least(looks: number, enough: number, look: () => Promise<number>): Promise<number> {
  let found = Infinity;
  for (let i = 0; i < looks && found > enough; i++) found = Math.min(found, await look());
  return found;
}

test.describe.configure({ mode: 'parallel' });

/** Two tests share the techniques, for two workers. */
for (const half of [0, 1]) {
  test(`a frame allocates no more than it may for each light and object, and keeps nothing, half ${half + 1}`, async ({
    page,
  }) => {
    test.setTimeout(180_000);
    const session = await page.context().newCDPSession(page);
    await session.send('HeapProfiler.enable');
    const look = () => allocated(page, session);
    const techniques = await page.evaluate(() => [...window.perf.techniques]);
    for (const technique of techniques.filter((_, index) => index % 2 === half)) {
      const drawn = await prepare(page, technique, 100, 20);
      const { garbageOfLight } = budgetOf(drawn);
      const few = await least(3, 0, look);
      const left = await least(LOOKS, KEPT, () => kept(page, session));

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
