import type { LazyPart } from '@farol/renderer';
import type { Page } from '@playwright/test';
import type { LateCase } from '../pages/lateCases';
import { expect, test } from '../support/test';

declare global {
  interface Window {
    late: LateCase;
  }
}

/** Opens a page in which no part of the code is there. */
async function openLazy(page: Page, pagesURL: string): Promise<void> {
  await page.goto(`${pagesURL}?lazy`);
  await page.waitForFunction(() => 'testPage' in window);
}

/** Holds all that the page fetches from now on. @returns lets it through */
async function hold(page: Page): Promise<() => void> {
  let release = (): void => {};
  const held = new Promise<void>((resolve) => (release = resolve));
  await page.route('**/*', async (route) => {
    await held;
    await route.continue();
  });
  return release;
}

const partsOf = (page: Page): Promise<readonly LazyPart[]> =>
  page.evaluate(() => window.testPage.farol.FarolRenderer.parts);

async function checkLate(page: Page, part: LazyPart): Promise<void> {
  if (part === 'nodes') await page.evaluate(async () => void (await window.testPage.nodeScene()));
  const release = await hold(page);
  const pending = await page.evaluate(async (part) => {
    window.late = await window.testPage.LateCase.of(part);
    return window.late.drawFrames();
  }, part);
  expect(pending, 'info.pending').toContain(part);
  const wait = page.evaluate(() => window.late.wait());
  expect(await page.evaluate(() => window.late.isReady), 'ready while the code is held').toBe(false);
  release();
  await wait;
  const differences = await page.evaluate((part) => window.late.differences(part), part);
  expect(differences, 'the frame after which it is ready, and two more').toEqual([0, 0, 0]);
}

/** A third of the parts, shadow maps among them, in `npm test`. */
for (const [turns, title] of [
  [[0], 'a third'],
  [[1, 2], 'the others @verify'],
] as const) {
  test(`a part of the code that comes late: ready waits for it, and frames from then on are as if it had been there, ${title}`, async ({
    page,
    pagesURL,
  }) => {
    await openLazy(page, pagesURL);
    for (const part of (await partsOf(page)).filter((_, i) => turns.some((turn) => turn === i % 3))) {
      await test.step(part, async () => {
        await openLazy(page, pagesURL);
        await checkLate(page, part);
      });
    }
  });
}
