import { launchBench } from './benchBrowser.mjs';

/**
 * @typedef {import('playwright-core').Page} Page
 *
 * @typedef {object} LabPlan see apps/lab/src/plan/LabPlan.ts
 * @property {string} label
 * @property {{ name: string, label: string, axis: string, cases: object[], values: number[] }[]} series
 * @property {string[]} competitors
 *
 * @typedef {object} LabRow as much of apps/lab/src/results/LabRun.ts as is read here
 * @property {string} competitor
 * @property {string} series
 * @property {number} index
 * @property {{ median: number } | null} frame
 * @property {{ thumbnail: string } | null} likeness
 * @property {string | null} problem
 *
 * @typedef {object} LabRun
 * @property {string} name
 * @property {LabPlan} plan
 * @property {LabRow[]} rows
 * @property {{ device: string, browser: string, build: string }} surroundings
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

/** Flags for WebGPU on Linux; the first without the last loses WebGL contexts. */
const webgpuFlags =
  process.platform === 'linux'
    ? ['--enable-unsafe-webgpu', '--enable-features=Vulkan', '--disable-gpu-compositing']
    : [];

/** Flags that keep timers and drawing at full rate in every state of the window. */
const steadyFlags = ['--disable-background-timer-throttling', '--disable-renderer-backgrounding'];

/** A browser with the Lab under `?headless`, used through `window.lab`. */
export class LabBrowser {
  /** @type {Awaited<ReturnType<typeof launchBench>> | null} */
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
   * Calls `work` in the page. Rejects with the message of its error.
   *
   * @template T, [A=undefined]
   * @param {(argument: A) => T | Promise<T>} work
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
      return /** @type {T} */ (await Promise.race([page.evaluate(/** @type {any} */ (work), argument), crash]));
    } catch (error) {
      const text = error instanceof Error ? error.message : String(error);
      const [message] = text.replace(/^page\.\w+: (\w*Error: )?/, '').split(/\n\s+at /);
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
      ({ plan, command, versions, crashes }) => {
        const { lab, benchStep, benchCase } = /** @type {LabWindow} */ (/** @type {unknown} */ (window));
        return lab.run(plan, { command, versions, crashes, onStep: benchStep, onCase: benchCase });
      },
      { plan, command, versions, crashes },
    );
    measured.catch(() => {}); // the browser may be killed while it is at work
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
    await running?.server.kill(); // a page that hangs would not let it close
  }

  async #open() {
    if (this.#page) return this.#page;
    const { gpu, url } = this.options;
    this.#running = await launchBench(this.options, [...steadyFlags, ...(gpu ? webgpuFlags : [])]);
    const context = await this.#running.browser.newContext({ viewport: { width: 640, height: 360 } });
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
