import type { Page } from '@playwright/test';
import { test as base } from './test';

export { expect } from '@playwright/test';

/**
 * As `test` of ./test, with one page for all tests of a worker in place of one each. For tests that neither reload the page
 * nor change what it runs on: its storage, its network, what the browser can do.
 *
 * @param app - the page's
 * @param open - opens the page, before the first of its tests
 * @param reset - puts the page back to how it opens, before each of the others
 */
export const testWithSharedPage = (
  app: 'editor' | 'viewer',
  open: (page: Page) => Promise<void>,
  reset: (page: Page) => Promise<void>,
) =>
  base.extend<{ isPutBack: void }>({
    context: async ({ sharedPages }, use) => use((await sharedPages(app)).context()),

    page: async ({ sharedPages }, use) => {
      const page = await sharedPages(app);
      await use(page);
      for (const other of page.context().pages()) if (other !== page) await other.close();
    },

    isPutBack: [
      async ({ page, viewport, reducedMotion, watch }, use) => {
        void watch;
        await page.setViewportSize(viewport!);
        await page.emulateMedia({ reducedMotion });
        if (page.url() === 'about:blank') await open(page);
        else await reset(page);
        await use();
      },
      { auto: true },
    ],
  });
