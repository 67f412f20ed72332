import { gpuFlags, softwareFlags } from './browserFlags.mjs';

/**
 * @typedef {import('playwright-core').Page} Page
 *
 * @typedef {{ name: string, label: string, axis: string, cases: object[], values: number[] }} LabSeries
 *
 * @typedef {object} LabPlan see apps/lab/src/plan/LabPlan.ts
 * @property {string} label
 * @property {LabSeries[]} series
 * @property {string[]} competitors
 * @property {{ rounds: number }} effort
 *
 * @typedef {object} LabRow as much of apps/lab/src/results/LabRun.ts as is read here
 * @property {string} competitor
 * @property {string} series
 * @property {number} index
 * @property {{ median: number } | null} frame
 * @property {{ median: number } | null} cpu
 * @property {{ median: number } | null} gpu
 * @property {number | null} firstMs
 * @property {{ draws: number | null, programs: number | null } | null} counts
 * @property {string | null} technique
 * @property {string[]} warnings
 * @property {{ thumbnail: string } | null} likeness
 * @property {string | null} problem
 *
 * @typedef {object} LabRun
 * @property {string} name
 * @property {LabPlan} plan
 * @property {LabRow[]} rows
 * @property {{ date: string, device: string, browser: string, build: string, command: string | null }} surroundings
 * @property {boolean} complete
 *
 * @typedef {{ done: number, total: number, remaining: number | null, competitor: string | null, labCase: object }} Step
 * @typedef {{ competitor: string, labCase: object }} Crash
 *
 * @typedef {object} RunHandlers
 * @property {string} command
 * @property {Record<string, string>} versions
 * @property {Crash[]} crashes what is not opened again
 * @property {(step: Step) => void} onStep
 * @property {(run: LabRun) => void} onCase
 *
 * @typedef {object} LabHandle `window.lab`; see apps/lab/src/labHandle.ts
 * @property {Record<string, { label: string, kind: string }>} competitors
 * @property {(fragment: string) => any} configurationOf
 * @property {(device: { software: boolean }) => any} quickFor
 * @property {(configuration: any) => LabPlan} planOf
 * @property {(plan: LabPlan, options: object) => Promise<LabRun>} run
 * @property {() => Promise<LabRun['surroundings']>} surroundings
 * @property {() => void} cancel
 * @property {(run: LabRun) => LabPlan} remaining
 * @property {(plan: LabPlan, parts: LabRun[]) => LabRun} merge
 * @property {(json: string) => LabRun} parse
 * @property {(run: LabRun) => { name: string, text: string }[]} files
 *
 * @typedef {{ lab: LabHandle, benchStep(step: Step): void, benchCase(run: LabRun): void }} LabWindow
 */

/** Flags for WebGPU on Linux; without the last, the first makes WebGL contexts get lost. */
const webgpuFlags =
  process.platform === 'linux'
    ? ['--enable-unsafe-webgpu', '--enable-features=Vulkan', '--disable-gpu-compositing']
    : [];

/** Settings that turn shader caches off, so that every first frame compiles its programs, as on a new machine. */
const noCaches = {
  flags: ['--disable-gpu-program-cache', '--disable-gpu-shader-disk-cache'],
  env: { __GL_SHADER_DISK_CACHE: '0', MESA_SHADER_CACHE_DISABLE: 'true' },
};

/** Flags that keep timers and drawing at full rate in every state of the window. */
const steadyFlags = ['--disable-background-timer-throttling', '--disable-renderer-backgrounding'];

/** A browser with the Lab under `?headless`, used through `window.lab`. */
export class LabBrowser {
  /** @type {import('playwright-core').BrowserServer | null} */
  #running = null;
  /** @type {Page | null} */
  #page = null;
  /** @type {RunHandlers | null} */
  #handlers = null;
  #lastStep = 0;

  /** @param {{ executablePath: string, gpu: boolean, url: string, timeout: number }} options - timeout in s */
  constructor(options) {
    this.options = options;
  }

  /**
   * Calls `work` in the page, with `window.lab` before its argument. Rejects with the message of its error.
   *
   * @template T, [A=undefined]
   * @param {(lab: LabHandle, argument: A) => T | Promise<T>} work
   * @param {A} [argument]
   * @returns {Promise<T>}
   */
  async call(work, argument) {
    const page = await this.#open();
    let crashed = () => {};
    const crash = new Promise((_, reject) => {
      crashed = () => reject(new Error('the page crashed'));
      page.once('crash', crashed);
    });
    try {
      const lab = await page.evaluateHandle('lab');
      return /** @type {T} */ (await Promise.race([lab.evaluate(/** @type {any} */ (work), argument), crash]));
    } catch (error) {
      const text = error instanceof Error ? error.message : String(error);
      const [message] = text.replace(/^\w+\.\w+: (\w*Error: )?/, '').split(/\n\s+at /);
      throw new Error(message, { cause: error });
    } finally {
      page.off('crash', crashed);
    }
  }

  /**
   * Measures a plan.
   *
   * @param {LabPlan} plan
   * @param {RunHandlers} handlers
   * @returns {Promise<LabRun>}
   * @throws {Error} when the page crashes, or makes no step for `timeout` seconds; `onCase` got the cases before
   */
  async run(plan, handlers) {
    this.#handlers = handlers;
    this.#lastStep = performance.now();
    const { command, versions, crashes } = handlers;
    const { timeout } = this.options;
    /** @type {NodeJS.Timeout | undefined} */
    let timer;
    const stalled = new Promise((_, reject) => {
      timer = setInterval(() => {
        if (performance.now() - this.#lastStep > timeout * 1000) reject(new Error(`no step for ${timeout} s`));
      }, 1000);
    });
    const measured = this.call(
      (lab, { plan, command, versions, crashes }) => {
        const { benchStep, benchCase } = /** @type {LabWindow} */ (/** @type {unknown} */ (window));
        return lab.run(plan, { command, versions, crashes, onStep: benchStep, onCase: benchCase });
      },
      { plan, command, versions, crashes },
    );
    measured.catch(() => {}); // killing the browser rejects this promise: without the handler Node would end
    try {
      return /** @type {LabRun} */ (await Promise.race([measured, stalled]));
    } finally {
      clearInterval(timer);
    }
  }

  /** Cancels the run, whose promise then resolves with the rows so far. */
  async cancel() {
    await this.#page?.evaluate(() => /** @type {LabWindow} */ (/** @type {unknown} */ (window)).lab.cancel());
  }

  async close() {
    const running = this.#running;
    this.#running = null;
    this.#page = null;
    await running?.kill(); // killed, since a page that hangs would keep the browser from closing
  }

  async #open() {
    if (this.#page) return this.#page;
    const { executablePath, gpu, url } = this.options;
    const args = [...noCaches.flags, ...steadyFlags, ...(gpu ? [...gpuFlags, ...webgpuFlags] : softwareFlags)];
    // imported late: playwright-core may not be installed when this module loads
    const { chromium } = await import('playwright-core');
    this.#running = await chromium.launchServer({ executablePath, args, env: { ...process.env, ...noCaches.env } });
    const browser = await chromium.connect(this.#running.wsEndpoint());
    const context = await browser.newContext({ viewport: { width: 640, height: 360 } });
    const page = await context.newPage();
    page.on('pageerror', (error) => console.error(`page error: ${error.message}`));
    await page.exposeFunction('benchStep', (/** @type {Step} */ step) => {
      this.#lastStep = performance.now();
      this.#handlers?.onStep(step);
    });
    await page.exposeFunction('benchCase', (/** @type {LabRun} */ run) => this.#handlers?.onCase(run));
    await page.goto(`${url}?headless`);
    await page
      .waitForFunction(() => 'lab' in window, null, { timeout: 30_000 })
      .catch(() => {
        throw new Error('The page offers no window.lab: it is no Lab, or an older one. Build it anew.');
      });
    this.#page = page;
    return page;
  }
}
