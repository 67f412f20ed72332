import { gpuFlags, softwareFlags } from './browserFlags.mjs';
import { installCounters } from './benchCounters.mjs';
import { installFirstFrame, measureViewer } from './benchMeasure.mjs';

/**
 * @typedef {import('./benchCases.mjs').Known} Known
 * @typedef {import('./benchMeasure.mjs').BenchWindow} BenchWindow
 * @typedef {import('./benchMeasure.mjs').Measurement} Measurement
 * @typedef {import('./benchMeasure.mjs').MeasureOptions} MeasureOptions
 * @typedef {{ measurement: Measurement, error: null } | { measurement: null, error: string }} CaseResult
 */

/** So that every first frame compiles its programs, as on a machine that never saw them. */
const noCaches = {
  flags: ['--disable-gpu-program-cache', '--disable-gpu-shader-disk-cache', '--enable-precise-memory-info'],
  env: { __GL_SHADER_DISK_CACHE: '0', MESA_SHADER_CACHE_DISABLE: 'true' },
};

/**
 * Starts a browser to measure in, with a server process that can be killed.
 *
 * @param {{ executablePath: string, gpu: boolean }} options
 * @param {readonly string[]} [more] - flags
 */
export async function launchBench({ executablePath, gpu }, more = []) {
  const args = [...(gpu ? gpuFlags : softwareFlags), ...noCaches.flags, ...more];
  // not before it is installed
  const { chromium } = await import('playwright-core');
  const server = await chromium.launchServer({ executablePath, args, env: { ...process.env, ...noCaches.env } });
  const browser = await chromium.connect(server.wsEndpoint());
  return { server, browser };
}

/** A browser that measures pages of the viewer, each in a context of its own; started anew after one that failed. */
export class BenchBrowser {
  /** @type {{ server: import('playwright-core').BrowserServer, browser: import('playwright-core').Browser } | null} */
  #running = null;

  /** @param {{ executablePath: string, gpu: boolean }} options */
  constructor(options) {
    this.options = options;
    /** Version of the browser, once it ran. */
    this.version = '';
  }

  /**
   * Measures one case. Whatever goes wrong in the page is a result.
   *
   * @param {string} url
   * @param {MeasureOptions & { timeout: number }} options - timeout in s
   * @returns {Promise<CaseResult>}
   */
  async measure(url, options) {
    return this.#inPage(url, options.timeout, (page) => page.evaluate(measureViewer, options));
  }

  /**
   * Scenes and techniques of a viewer.
   *
   * @param {string} url
   * @param {number} timeout - s
   * @returns {Promise<Known>}
   * @throws {Error} when it does not start
   */
  async known(url, timeout) {
    const query = '?scene=benchmarkLights&n=1&m=1&time=0&width=16&height=16&dpr=1&gui=0';
    const { measurement, error } = await this.#inPage(`${url}${query}`, timeout, (page) =>
      page.evaluate(() => {
        const { known } = /** @type {BenchWindow} */ (/** @type {unknown} */ (window)).viewer;
        const scenes = Object.entries(known.scenes).map(([name, { parameters }]) => [name, Object.keys(parameters)]);
        return { techniques: [...known.techniques], scenes: Object.fromEntries(scenes) };
      }),
    );
    if (error !== null) throw new Error(`The viewer does not start: ${error}`);
    return measurement;
  }

  async close() {
    const running = this.#running;
    this.#running = null;
    await running?.server.kill(); // a page that hangs would not let it close
  }

  /**
   * @template T
   * @param {string} url
   * @param {number} timeout - s
   * @param {(page: import('playwright-core').Page) => Promise<T>} work - done when the first scene is drawn
   * @returns {Promise<{ measurement: T, error: null } | { measurement: null, error: string }>}
   */
  async #inPage(url, timeout, work) {
    /** @type {NodeJS.Timeout | undefined} */
    let timer;
    const late = new Promise((_, failed) => {
      timer = setTimeout(() => failed(new Error(`not done after ${timeout} s`)), timeout * 1000);
    });
    try {
      const measurement = /** @type {T} */ (await Promise.race([this.#openAndRun(url, work), late]));
      return { measurement, error: null };
    } catch (error) {
      await this.close();
      const text = error instanceof Error ? error.message : String(error);
      return { measurement: null, error: text.replace(/^page\.\w+: (Error: )?/, '').split('\n')[0] };
    } finally {
      clearTimeout(timer);
    }
  }

  /**
   * @template T
   * @param {string} url
   * @param {(page: import('playwright-core').Page) => Promise<T>} work
   */
  async #openAndRun(url, work) {
    const context = await (await this.#browser()).newContext({ viewport: { width: 640, height: 360 } });
    const page = await context.newPage();
    /** @type {string[]} */
    const problems = [];
    const crashed = new Promise((_, failed) => page.once('crash', () => failed(new Error('the page crashed'))));
    page.on('pageerror', (error) => problems.push(`page error: ${error.message}`));
    page.on('console', (message) => message.type() === 'error' && problems.push(`console error: ${message.text()}`));
    await page.addInitScript(installCounters);
    await page.addInitScript(installFirstFrame);
    await page.goto(url);
    const ready = page.evaluate(() => /** @type {BenchWindow} */ (/** @type {unknown} */ (window)).viewer.ready);
    try {
      await Promise.race([ready, crashed]);
      const result = /** @type {T} */ (await Promise.race([work(page), crashed]));
      if (problems.length > 0) throw new Error(problems[0]);
      await context.close();
      return result;
    } catch (error) {
      throw problems.length > 0 ? new Error(problems[0]) : error; // what the page said tells more
    }
  }

  async #browser() {
    if (!this.#running) {
      const { server, browser } = await launchBench(this.options);
      this.version = browser.version();
      this.#running = { server, browser };
    }
    return this.#running.browser;
  }
}
