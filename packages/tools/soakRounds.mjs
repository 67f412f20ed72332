import { growthOf } from './soakReport.mjs';

/**
 * @typedef {import('playwright-core').Page} Page
 * @typedef {{ acts: string[], difference: number, share: number, technique: string, problems: string[] }} Round
 * @typedef {{ rounds: number, mismatches: string[], messages: string[], samples: import('./soakReport.mjs').Sample[],
 *   table: Record<string, number>, left: Record<string, number> }} SoakResult left: GPU objects once all is disposed
 */

/** Console messages that the soak itself causes by lost contexts, and by views of buffers that a frame lacks. */
const expected = [
  /CONTEXT_LOST_WEBGL: loseContext/,
  /GPU stall due to ReadPixels/,
  /Automatic fallback to software WebGL/,
  /^Farol: the view '[a-z-]+' shows the final picture\./,
];

/** A channel that differs by more is a mismatch (of 255). */
const NEAR = 1;

/**
 * Takes a renderer through seeded rounds of everything that can happen to it, for a time: see e2e/pages/soak.
 *
 * @param {Page} page
 * @param {object} options
 * @param {string} options.url - where e2e/pages are served
 * @param {number} options.seed
 * @param {(rounds: number) => boolean} options.isOver - asked after each round
 * @param {number} [options.every] - rounds from one measurement to the next
 * @param {readonly string[]} [options.without] - kinds of acts that are left out
 * @param {(line: string) => void} [options.say]
 * @returns {Promise<SoakResult>}
 */
export async function soakRounds(page, { url, seed, isOver, every = 10, without = [], say = () => {} }) {
  /** @type {SoakResult} */
  const result = { rounds: 0, mismatches: [], messages: [], samples: [], table: {}, left: {} };
  /** @type {string[]} */
  let heard = [];
  page.on('console', (message) => {
    if (message.type() !== 'error' && message.type() !== 'warning') return;
    if (!expected.some((pattern) => pattern.test(message.text()))) heard.push(`${message.type()}: ${message.text()}`);
  });
  page.on('pageerror', (error) => heard.push(`page error: ${error.message}`));
  await page.goto(`${url}soak.html`);
  await page.waitForFunction(() => 'Soak' in window);
  await page.evaluate(
    ({ seed, without }) => {
      const { Soak } = /** @type {any} */ (window);
      /** @type {any} */ (window).soak = new Soak(
        seed,
        Soak.kinds.filter((/** @type {string} */ kind) => !without.includes(kind)),
      );
    },
    { seed, without },
  );
  const cdp = await page.context().newCDPSession(page);
  const begin = performance.now();
  do {
    /** @type {Round} */
    const round = await page.evaluate(() => /** @type {any} */ (window).soak.round());
    result.rounds++;
    const at = `round ${result.rounds}, ${round.technique}, after ${round.acts.join('; ')}`;
    const problems = [...round.problems, ...heard];
    heard = [];
    for (const problem of new Set(problems)) result.messages.push(`${problem.slice(0, 300)} (${at})`);
    if (round.difference > NEAR) {
      result.mismatches.push(`${round.difference} of 255, ${(round.share * 100).toFixed(2)}% of channels (${at})`);
    }
    const found = round.difference > NEAR || problems.length > 0;
    if (found) say(`${[...result.mismatches.slice(-1), ...result.messages.slice(-1)].join('\n')}`);
    if (result.rounds % every === 0) {
      const { objects, table } = await page.evaluate(() => /** @type {any} */ (window).soak.rest());
      // twice: what a finaliser frees goes with the second
      for (let i = 0; i < 2; i++) await cdp.send('HeapProfiler.collectGarbage');
      const { usedSize } = await cdp.send('Runtime.getHeapUsage');
      result.table = table;
      result.samples.push({ minutes: (performance.now() - begin) / 60_000, heap: usedSize / 1024, objects });
    }
  } while (!isOver(result.rounds));
  result.left = await page.evaluate(() => /** @type {any} */ (window).soak.end());
  await cdp.detach();
  return result;
}

/** Faults of a run, a line each; empty when there is none. @param {SoakResult} result */
export function soakFaults({ mismatches, messages, samples }) {
  return [...mismatches, ...messages, ...growthOf(samples).grows];
}
