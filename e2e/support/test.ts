import { basename, dirname } from 'node:path';
import { type BrowserContext, type ConsoleMessage, type Page, test as base } from '@playwright/test';
import { byExtent, extent, isWhole } from '@farol/tools/extent';

export { expect } from '@playwright/test';

/** App that the tests of a folder open by `page.goto('./')`; the viewer for the others. */
const apps: Record<string, string | undefined> = {
  editor: 'EDITOR',
  examples: 'PAGES',
  gallery: 'LIVE',
  lab: 'LAB',
  rivals: 'LAB',
};
/** Folders whose tests have a window of a desktop's size, unless they ask for another. */
const desktop = new Set(['editor', 'lab']);

/** Device pixels for each CSS pixel in tests of the editor, whose pages are large and seldom compared as pictures. */
export const pixelRatio = byExtent({ slice: 0.5, verify: 1 });

/** Folder of e2e/ that holds a test's file. */
const folderOf = (file: string): string => basename(dirname(file));

/** The browser's remarks that say nothing about our code. */
const harmless = [
  // Chromium itself, when pixels are read back: the read is what the test asks for.
  /GPU stall due to (ReadPixels|mapping device local buffer)/,
  /Automatic fallback to software WebGL/,
  // playwright.config.ts blocks service workers
  /Service Worker registration blocked by Playwright/,
  // ANGLE on Vulkan, where one of its render passes ends for many commands outside of it: a hint on its own bookkeeping
  /GL Driver Message .*Performance.*Running out of reserved outsideRenderPass queueSerial/,
  // Chromium's answer to requestAdapter() where it has no WebGPU
  /No available adapters/,
];

/** Tells the console of each WebGL context of the page that is lost. */
function reportLosses(): void {
  const report = () => console.error('a WebGL context was lost');
  addEventListener('webglcontextlost', report, { capture: true });
  // Events of a canvas outside of the document do not come by the window.
  const reportOutside = ({ target }: Event) => (target as HTMLCanvasElement).isConnected || report();
  const getContext = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (this: HTMLCanvasElement, ...args: unknown[]) {
    if (String(args[0]).startsWith('webgl')) this.addEventListener('webglcontextlost', reportOutside);
    return (getContext as (...all: unknown[]) => RenderingContext | null).apply(this, args);
  } as typeof getContext;
}

/**
 * Makes three filter environments by fewer samples: 256 for each of 400,000 texels take the rasteriser 3 s, a sky. Stock
 * three and Farol draw by the same filter, so their pictures stay comparable.
 */
function filterRoughly(): void {
  const { prototype } = WebGL2RenderingContext;
  const { shaderSource } = prototype;
  prototype.shaderSource = function (this: WebGL2RenderingContext, shader, source) {
    shaderSource.call(this, shader, source.replace('#define GGX_SAMPLES 256u', '#define GGX_SAMPLES 8u'));
  };
}

/** Pages that have {@link reportLosses}. */
const reporting = new WeakSet<Page>();
/** Contexts whose pages have {@link filterRoughly}, in the slice. */
const filtering = new WeakSet<BrowserContext>();

export interface Watch {
  /** Problems seen so far: console errors and warnings, page errors, lost WebGL contexts. */
  readonly problems: string[];
  /** Takes the seen problems that match away, for a test that provokes them. Gives how many there were. */
  forgive(pattern: RegExp): number;
}

/**
 * Playwright's `test`, where any console error or warning, error of the page or loss of a WebGL context fails the test.
 *
 * - `watch`: the problems seen; a test that provokes one calls `watch.forgive(/…/)`.
 * - `pagesURL`: where the tests' own pages (e2e/pages) are served, with a slash at its end.
 * - `benchPage`: the first of them, open, with what it offers as `window.testPage`.
 * - `sharedPages`: gives the page of an app, or for Benches, that tests of a worker share: see sharedPage.ts and
 *   benchTest.ts. Every test has this fixture, since one more kind of worker would be one more browser, which compiles all
 *   shaders anew.
 */
export const test = base.extend<
  { watch: Watch; pagesURL: string; benchPage: Page },
  { sharedPages: (app: 'editor' | 'viewer' | 'bench') => Promise<Page> }
>({
  sharedPages: [
    async ({ browser }, use) => {
      const pages = new Map<string, Promise<Page>>();
      const contexts: BrowserContext[] = [];
      const make = async (app: string): Promise<Page> => {
        const context = await browser.newContext({
          baseURL: process.env[`FAROL_${app.toUpperCase()}_URL`],
          serviceWorkers: 'block',
          deviceScaleFactor: app === 'editor' ? pixelRatio : undefined,
          viewport: { width: 640, height: 360 },
        });
        const page = await context.newPage();
        // a test that ends the processes of all pages (deadTab.ts) leaves the next one a new page
        page.once('crash', () => pages.delete(app));
        contexts.push(context);
        return page;
      };
      await use((app) => {
        const page = pages.get(app) ?? make(app);
        pages.set(app, page);
        return page;
      });
      for (const context of contexts) await context.close();
    },
    { scope: 'worker' },
  ],

  // oxlint-disable-next-line no-empty-pattern -- Playwright reads the names of the fixtures from the pattern
  pagesURL: async ({}, use) => use(process.env.FAROL_PAGES_URL ?? ''),

  baseURL: async ({ baseURL }, use, { file }) =>
    use(baseURL ?? process.env[`FAROL_${apps[folderOf(file)] ?? 'VIEWER'}_URL`]),

  viewport: async ({ viewport }, use, { file, project }) => {
    const isUsual = viewport === project.use.viewport;
    return use(isUsual && desktop.has(folderOf(file)) ? { width: 1280, height: 720 } : viewport);
  },

  deviceScaleFactor: async ({ deviceScaleFactor }, use, { file }) =>
    use(deviceScaleFactor ?? (folderOf(file) === 'editor' ? pixelRatio : undefined)),

  watch: [
    async ({ page }, use) => {
      const problems: string[] = [];
      const told = (message: ConsoleMessage): void => {
        if (message.type() !== 'error' && message.type() !== 'warning') return;
        if (harmless.some((pattern) => pattern.test(message.text()))) return;
        problems.push(`console ${message.type()}: ${message.text()} (${message.location().url})`);
      };
      const failed = (error: Error): void => void problems.push(`page error: ${error.stack ?? error.message}`);
      page.on('console', told).on('pageerror', failed);
      if (!reporting.has(page)) await page.addInitScript(reportLosses);
      const context = page.context();
      // also for the pages that a test opens
      if (!isWhole && !filtering.has(context)) await context.addInitScript(filterRoughly);
      filtering.add(context);
      reporting.add(page);
      await use({
        problems,
        forgive(pattern) {
          const kept = problems.filter((problem) => !pattern.test(problem));
          const count = problems.length - kept.length;
          problems.splice(0, problems.length, ...kept);
          return count;
        },
      });
      page.off('console', told).off('pageerror', failed);
      base.expect(problems, 'console errors and warnings, page errors, lost contexts').toEqual([]);
    },
    { auto: true },
  ],

  benchPage: async ({ page, pagesURL }, use) => {
    await page.goto(`${pagesURL}?tests=${extent}`);
    await page.waitForFunction(() => 'testPage' in window);
    await use(page);
  },
});
