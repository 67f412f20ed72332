/**
 * @typedef {object} CompatRow
 * @property {string} version of three
 * @property {number} count pictures compared
 * @property {number} good pictures within their limits
 * @property {number} exceptions pictures that are named exceptions
 * @property {number} failed pictures off their limits, and one for each of `units`, `tests`, `types` that is false
 * @property {number} largest error of a channel, linear
 * @property {number} psnr least, dB
 * @property {boolean} units whether the renderer's unit tests pass
 * @property {boolean} tests whether the browser tests pass
 * @property {boolean} types whether declarations and samples compile with its types
 */

/**
 * @param {string} version - of three
 * @param {string} comparisons - a line of JSON each, as AgreementReporter.ts writes them
 * @param {{ tests: boolean, units: boolean, types: boolean }} passed
 * @returns {CompatRow}
 * @throws {Error} when nothing was compared
 */
export function compatRow(version, comparisons, { tests, units, types }) {
  const all = comparisons
    .split('\n')
    .filter((line) => line !== '')
    .map((line) => JSON.parse(line));
  if (all.length === 0) throw new Error(`three ${version}: no picture was compared; see the tests' output.`);
  const exceptions = all.filter(({ exception }) => exception).length;
  const held = all.filter(({ exception }) => !exception);
  const good = held.filter((one) => one.good).length;
  return {
    version,
    count: all.length,
    good,
    exceptions,
    failed: held.length - good + (tests ? 0 : 1) + (units ? 0 : 1) + (types ? 0 : 1),
    largest: Math.max(0, ...held.map(({ largest }) => Number(largest))),
    psnr: Math.min(Infinity, ...held.map(({ psnr }) => Number(psnr))),
    units,
    tests,
    types,
  };
}

/** @param {CompatRow[]} rows @returns {string} a table in Markdown */
export function compatTable(rows) {
  const said = (/** @type {boolean} */ passed) => (passed ? 'pass' : 'FAIL');
  return [
    '| three | pictures | within limits | named exceptions | largest error | least PSNR (dB) | browser tests | unit tests | types |',
    '| --- | --- | --- | --- | --- | --- | --- | --- | --- |',
    ...rows.map(
      ({ version, count, good, exceptions, largest, psnr, tests, units, types }) =>
        `| ${version} | ${count} | ${good} | ${exceptions} | ${largest.toExponential(1)} | ${psnr.toFixed(1)} | ${said(tests)} | ${said(units)} | ${said(types)} |`,
    ),
  ].join('\n');
}
