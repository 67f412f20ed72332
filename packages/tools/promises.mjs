/**
 * @typedef {object} Promised a promise of a page
 * @property {string} name its words in bold
 * @property {{ path: string, titles: string[] }[]} tests files that it names, from the repository's root, and titles of tests,
 *   or parts of titles, in them
 */

/**
 * Promises of a page: list items that begin in bold. The tests of each stand behind it as `path` "title", "title".
 *
 * @param {string} page - Markdown
 * @returns {Promised[]}
 */
export function promisesOf(page) {
  return [...page.matchAll(/^- \*\*(.+?)\*\*(.*)$/gm)].map(([, name, rest]) => ({
    name,
    tests: [...rest.matchAll(/`([\w./-]+\.(?:spec|test)\.tsx?)`((?:,? "[^"]+")*)/g)].map(([, path, titles]) => ({
      path,
      titles: [...titles.matchAll(/"([^"]+)"/g)].map(([, title]) => title),
    })),
  }));
}

/**
 * Reasons why a promise is not held: no test, a file that is not there, a title that no test of `npm run verify` has.
 *
 * @param {Promised} promise
 * @param {(path: string) => string | null} read - gives the source of a test file, null where there is none
 * @returns {string[]} a line each
 */
export function promiseFaults({ name, tests }, read) {
  if (tests.length === 0) return [`${name}: no test is named`];
  return tests.flatMap(({ path, titles }) => {
    const source = read(path);
    if (source === null) return [`${name}: there is no ${path}`];
    if (titles.length === 0) return [`${name}: no title of a test of ${path} is named`];
    return titles.flatMap((title) => {
      const at = source.indexOf(title);
      if (at < 0) return [`${name}: ${path} has no test "${title}"`];
      const line = source.slice(source.lastIndexOf('\n', at) + 1, source.indexOf('\n', at));
      return /@long\b|\.skip\(/.test(line) ? [`${name}: "${title}" does not run in verify`] : [];
    });
  });
}
