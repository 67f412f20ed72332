import { relative } from 'node:path';

/**
 * Failed tests of a Playwright JSON report.
 *
 * @param {any} report
 * @returns {{ title: string, place: string }[]} `place` is file:line, as Playwright takes it for a filter
 */
export function failedPlaywrightTests(report) {
  /** @type {{ title: string, place: string }[]} */
  const failed = [];
  /** @param {any} suite @param {string[]} titles */
  const visit = (suite, titles) => {
    for (const { ok, title, file, line } of suite.specs ?? []) {
      if (!ok) failed.push({ title: [...titles, title].join(' > '), place: `${file}:${line}` });
    }
    for (const inner of suite.suites ?? []) visit(inner, [...titles, inner.title]);
  };
  for (const suite of report.suites ?? []) visit(suite, [suite.title]);
  return failed;
}

/**
 * Failed tests of a Vitest JSON report; of a file that could not be loaded, the file.
 *
 * @param {any} report
 * @param {string} root - folder that the places are relative to
 * @returns {{ title: string, place: string }[]} `place` is the file
 */
export function failedVitestTests(report, root) {
  return report.testResults
    .filter((/** @type {any} */ file) => file.status === 'failed')
    .flatMap((/** @type {any} */ file) => {
      const place = relative(root, file.name).replaceAll('\\', '/');
      const tests = file.assertionResults.filter((/** @type {any} */ test) => test.status === 'failed');
      if (tests.length === 0) return [{ title: place, place }];
      return tests.map((/** @type {any} */ test) => ({ title: `${place} > ${test.fullName}`, place }));
    });
}
