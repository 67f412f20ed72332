import { extent } from '@farol/tools/extent';
import { expect, test as base } from './test';

export { expect } from '@playwright/test';

const addressOf = (pagesURL: string): string => `${pagesURL}?tests=${extent}`;

/** Number of contexts above which the page is loaded anew: a browser loses the oldest of more than 16. */
const MOST_CONTEXTS = 13;

/**
 * As `test` of ./test, with one page for all tests of a worker. A shader is compiled once for each WebGL context, which is what
 * these tests take their time for: the Benches of a test have the contexts of those before it.
 *
 * A test that changes what the page runs on (methods of WebGL, three's own objects) puts it back, or is one of `test`, as one
 * that opens another page is.
 */
export const test = base.extend({
  context: async ({ sharedPages }, use) => use((await sharedPages('bench')).context()),

  page: async ({ sharedPages, pagesURL }, use) => {
    const page = await sharedPages('bench');
    await use(page);
    // another address would take the compiled shaders away from the tests after it
    expect(['about:blank', addressOf(pagesURL)], 'the page of Benches is left where it was').toContain(page.url());
  },

  benchPage: async ({ page, pagesURL }, use) => {
    const url = addressOf(pagesURL);
    if (page.url() !== url) {
      await page.goto(url);
      await page.waitForFunction(() => 'testPage' in window);
    }
    await use(page);
    const contexts = await page.evaluate(() => window.testPage.Bench.release());
    if (contexts > MOST_CONTEXTS) await page.goto('about:blank');
  },
});
