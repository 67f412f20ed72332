/**
 * How much the tests go through. `slice`: every subject, as `npm test` runs it. `verify`: everything. `long`: everything,
 * with the rounds of soak, fuzz and losses at full length.
 *
 * @typedef {'slice' | 'verify' | 'long'} Extent
 */

/** @type {readonly Extent[]} */
const extents = ['slice', 'verify', 'long'];

/**
 * @param {string | undefined} value of the environment variable FAROL_TESTS
 * @returns {Extent} slice when it is unset
 * @throws {Error} for any other value
 */
export function extentOf(value = 'slice') {
  const extent = extents.find((name) => name === value);
  if (!extent)
    throw new Error(`FAROL_TESTS is "${value}": set it to ${extents.join(', ')}, or leave it unset (slice).`);
  return extent;
}

/** Extent of this run, from the environment variable FAROL_TESTS. */
export const extent = extentOf(process.env.FAROL_TESTS);

/** Whether this run leaves nothing out: tests of verify run too, and loops have their full length. */
export const isWhole = extent !== 'slice';
