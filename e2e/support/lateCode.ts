import { extent } from '@farol/tools/extent';
import type { Page } from '@playwright/test';

/** Opens a page in which no part of the renderer's code is there that is fetched late. */
export async function openLazy(page: Page, pagesURL: string): Promise<void> {
  await page.goto(`${pagesURL}?lazy&tests=${extent}`);
  await page.waitForFunction(() => 'testPage' in window);
}

/** Holds all that the page fetches from now on. @returns lets it through */
export async function hold(page: Page): Promise<() => void> {
  let release = (): void => {};
  const held = new Promise<void>((resolve) => (release = resolve));
  await page.route('**/*', async (route) => {
    await held;
    await route.continue();
  });
  return release;
}
