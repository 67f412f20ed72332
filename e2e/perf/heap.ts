import type { CDPSession, Page } from '@playwright/test';

/** Frames of one look at the heap. */
const FRAMES = 50;
/** Frames of a count: what is allocated in one of so many is in every count. */
const COUNTED = 600;
/** Share by which two looks differ whose code is the same. */
const ALIKE = 0.05;
/** Looks until what is compiled late has been compiled. */
export const LOOKS = 8;
/** Bytes that a frame may leave for good: less than the smallest object, which is what V8 itself adds meanwhile. */
export const KEPT = 10;

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
 * Bytes that JavaScript allocates in a frame whose lights move, collected or not: by V8's sampling heap profiler over some
 * frames, below the function that draws them. It samples every 256th byte on average and scales up, so 50 frames of 10 kB
 * are known to about 2%. What V8 allocates to compile is not in it.
 */
export async function allocated(page: Page, session: CDPSession, frames = FRAMES): Promise<number> {
  await session.send('HeapProfiler.startSampling', {
    samplingInterval: 256,
    includeObjectsCollectedByMajorGC: true,
    includeObjectsCollectedByMinorGC: true,
  });
  await page.evaluate((count) => window.perfFrames(count), frames);
  const { profile } = (await session.send('HeapProfiler.stopSampling')) as { profile: { head: ProfileNode } };
  const size = (node: ProfileNode): number => node.children.reduce((sum, child) => sum + size(child), node.selfSize);
  const inFrames = (node: ProfileNode): number =>
    node.callFrame.functionName === 'perfFrames'
      ? size(node)
      : node.children.reduce((sum, child) => sum + inFrames(child), 0);
  return inFrames(profile.head) / frames;
}

/** Bytes by which the heap, its garbage collected, is larger after a frame than before: over 1,000 frames. */
export async function kept(page: Page, session: CDPSession): Promise<number> {
  const frames = 1000;
  const used = async () => {
    await session.send('HeapProfiler.collectGarbage');
    return (await session.send('Runtime.getHeapUsage')).usedSize;
  };
  const before = await used();
  await page.evaluate((frames) => window.perfFrames(frames), frames);
  return ((await used()) - before) / frames;
}

/** Counts in place of one, where a machine is busy: V8 compiles in threads of its own, for which frames do not wait. */
const PATIENCE = 6;

/**
 * Bytes that JavaScript allocates in a frame, over {@link COUNTED} frames once two looks in a row agree: what frames allocate
 * until V8 has compiled their code comes once, and is left out; what some of them allocate again and again is in each count.
 *
 * @param limit - what is asked: above it, frames are counted anew
 */
export async function allocatedWarm(page: Page, session: CDPSession, limit = Infinity): Promise<number> {
  let found = Infinity;
  for (let i = 0; i < PATIENCE && (i === 0 || found > limit); i++) {
    let [before, last] = [Infinity, await allocated(page, session)];
    for (let look = 1; look < LOOKS && Math.abs(before - last) > ALIKE * last; look++)
      [before, last] = [last, await allocated(page, session)];
    found = Math.min(found, await allocated(page, session, COUNTED));
  }
  return found;
}

/** The least of some looks; no more looks than it takes to come to `enough`. */
export async function least(looks: number, enough: number, look: () => Promise<number>): Promise<number> {
  let found = Infinity;
  for (let i = 0; i < looks && found > enough; i++) found = Math.min(found, await look());
  return found;
}
