import { installCounters } from '@farol/tools/benchCounters';
import { test as base } from '../support/test';
import { installPerf } from './installPerf';

export { expect } from '@playwright/test';

/** The browser tests' `test`, on the tests' own page with `window.perf` and `window.farolCounters`. */
export const test = base.extend<{ perfPage: void }>({
  perfPage: [
    async ({ page, pagesURL }, use) => {
      await page.addInitScript(installCounters);
      await page.addInitScript(installPerf);
      await page.goto(pagesURL);
      await page.waitForFunction(() => 'testPage' in window);
      await use();
    },
    { auto: true },
  ],
});
