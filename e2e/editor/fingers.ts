import type { Page } from '@playwright/test';

export type Point = readonly [x: number, y: number];

/** Fingers on a page (CSS pixels), as the device tells of them: pressed together, moved in steps, and taken away. */
export interface Fingers {
  press(...points: Point[]): Promise<void>;
  /** To where each of those that are pressed shall be. */
  move(...points: Point[]): Promise<void>;
  /** Takes all away. */
  lift(): Promise<void>;
}

/** Puts fingers on a page, whose context must have touch. */
export async function makeFingers(page: Page): Promise<Fingers> {
  const session = await page.context().newCDPSession(page);
  let now: readonly Point[] = [];
  const send = (type: 'touchStart' | 'touchMove' | 'touchEnd', points: readonly Point[]): Promise<unknown> =>
    session.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) });
  return {
    async press(...points) {
      now = points;
      await send('touchStart', points);
    },
    async move(...points) {
      const from = now;
      const STEPS = 4;
      for (let step = 1; step <= STEPS; step++) {
        const between = (a: number, b: number): number => a + ((b - a) * step) / STEPS;
        now = points.map(([x, y], i) => [between(from[i][0], x), between(from[i][1], y)]);
        await send('touchMove', now);
      }
    },
    async lift() {
      now = [];
      await send('touchEnd', []);
    },
  };
}
