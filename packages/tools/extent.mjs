/**
 * How much the tests go through, by the variable FAROL_TESTS:
 *
 * - `slice` (default, `npm test`): something of every subject;
 * - `verify` (`npm run verify`, `agree`, `compat`, `devices`): all of it;
 * - `long` (`npm run losses`): `verify`, with what is repeated at random repeated a hundred times.
 */
export const extents = /** @type {const} */ (['slice', 'verify', 'long']);

/** @typedef {(typeof extents)[number]} Extent */

/**
 * @param {string | undefined} asked - value of FAROL_TESTS; `slice` when absent or empty
 * @returns {Extent}
 * @throws {Error} for a name that is no extent
 */
export function readExtent(asked) {
  const found = extents.find((name) => name === (asked || 'slice'));
  if (!found) throw new Error(`FAROL_TESTS is "${asked}": it can be ${extents.join(', ')}.`);
  return found;
}

export const extent = readExtent(process.env.FAROL_TESTS);

/** Whether this run is more than the slice. */
export const isWhole = extent !== 'slice';

/**
 * Picks the count of this run's extent.
 *
 * @template T
 * @param {{ slice: T, verify: T, long?: T }} counts - `long` is as `verify` when absent
 * @returns {T}
 */
export const byExtent = ({ slice, verify, long = verify }) => ({ slice, verify, long })[extent];
