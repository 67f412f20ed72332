import type { Page } from '@playwright/test';
import { expect, test } from '../support/benchTest';

/** Milliseconds by which frames may be off the budget 30 frames after the load has changed. */
const NEAR = 2;
/** Least scale of the budgets. */
const LEAST = 0.4;

interface Change {
  factor: number;
  /** Time of a frame 30 frames after the change (ms). */
  ms: number;
  scale: number;
  /** Steps of 1/64 between the largest and the least scale of 60 frames, from the 60th on. */
  sway: number;
  source: string;
}

function check(changes: readonly Change[], frame: number, source: string): void {
  for (const { factor, ms, scale, sway, source: had } of changes) {
    const said = `load × ${factor}, scale ${scale}`;
    expect.soft(had, said).toBe(source);
    expect.soft(ms, said).toBeLessThan(frame + NEAR);
    // at the largest scale a frame may be as fast as it likes
    if (scale < 1) expect.soft(ms, said).toBeGreaterThan(frame - NEAR);
    expect.soft(sway, `${said}: sway (steps)`).toBeLessThanOrEqual(1.001);
  }
  expect(changes.map(({ factor }) => factor)).toEqual([2, 1, 2, 1]);
  expect(Math.min(...changes.map(({ scale }) => scale))).toBeGreaterThan(LEAST);
}

test('a load that doubles and halves is drawn in the time of the budget 30 frames later, by a clock that goes with the pixels', async ({
  benchPage: page,
}) => {
  const changes = await page.evaluate(
    async ([frame, least]) => {
      const { BudgetLoad, atRelease } = await window.testPage.budgetLoad();
      const load = new BudgetLoad(320, 180);
      load.hideTimer();
      const { farol } = load.bench;
      const { now } = performance;
      atRelease(() => (performance.now = now));
      const pixel = (0.9 * frame) / (320 * 180);
      performance.now = () => load.work * pixel;
      farol.budget = { frame, min: least };
      const frames = (count: number) =>
        Array.from({ length: count }, () => {
          load.draw();
          return farol.info.budget!.scale;
        });
      frames(60);
      return [2, 1, 2, 1].map((factor) => {
        load.steps.value = factor;
        frames(29);
        const before = load.work;
        const [scale] = frames(1);
        const ms = (load.work - before) * pixel;
        frames(30);
        const scales = frames(60);
        const sway = 64 * (Math.max(...scales) - Math.min(...scales));
        return { factor, ms, scale, sway, source: farol.info.budget!.source };
      });
    },
    [16.7, LEAST] as const,
  );
  check(changes, 16.7, 'interval');
});

/** Changes a load that is such that a frame takes 0.9 of the budget, by real times. */
async function change(page: Page, frame: number, width: number, height: number, timed: boolean): Promise<Change[]> {
  return page.evaluate(
    async ([frame, least, width, height, timed]) => {
      const { BudgetLoad } = await window.testPage.budgetLoad();
      const load = new BudgetLoad(width, height);
      if (!timed) load.hideTimer();
      const { farol } = load.bench;
      const time = () => farol.info.budget!.ms ?? 0;
      farol.budget = { frame, min: 1 };
      await load.frames(20);
      while (time() < frame / 2) {
        load.steps.value *= 2;
        await load.frames(20);
      }
      load.steps.value = Math.round((load.steps.value * 0.9 * frame) / time());
      const steps = load.steps.value;
      farol.budget = { frame, min: least };
      await load.frames(60);
      const changes: Change[] = [];
      for (const factor of [2, 1, 2, 1]) {
        load.steps.value = factor * steps;
        await load.frames(30);
        const { ms, scale, source } = { ...farol.info.budget! };
        await load.frames(30);
        const scales = await load.frames(60);
        const sway = 64 * (Math.max(...scales) - Math.min(...scales));
        changes.push({ factor, ms: ms!, scale, sway, source });
      }
      return changes;
    },
    [frame, LEAST, width, height, timed] as const,
  );
}

test('a load that doubles and halves is held by the times of a graphics card @gpu @long', async ({
  benchPage: page,
}) => {
  check(await change(page, 8, 1920, 1080, true), 8, 'gpu');
});

test('a load that doubles and halves is held by intervals of the software rasteriser @software @long', async ({
  benchPage: page,
}) => {
  test.setTimeout(240_000);
  check(await change(page, 33, 320, 180, false), 33, 'interval');
});
