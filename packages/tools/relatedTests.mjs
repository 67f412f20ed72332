import { basename, dirname } from 'node:path/posix';

/** Unit tests that hold rules of the whole repository, quick enough to run after any change. */
const house = ['importDirection', 'importCircles', 'noClocks', 'shaderLines', 'subjects', 'texts'];

/**
 * Unit tests that a change is likely to break: those in the folder of a changed file, those that import it, and the
 * tests of files that import it (the unit test beside each).
 *
 * @param {readonly string[]} changed - paths from the repository's root, with `/`
 * @param {ReadonlyMap<string, string>} files - source of all TypeScript files, by path
 * @param {import('./importCircles.mjs').ImportGraph} imports - of those files
 * @returns {string[]} paths, sorted; those of `house` included
 */
export function relatedTests(changed, files, imports) {
  const isTest = (/** @type {string} */ path) => /\.test\.tsx?$/.test(path);
  const tests = [...files.keys()].filter(isTest);
  /** @type {Set<string>} */
  const found = new Set(tests.filter((path) => house.includes(basename(path, '.test.ts'))));
  for (const path of changed) {
    const folder = dirname(path);
    for (const test of tests) if (test === path || dirname(test) === folder) found.add(test);
    for (const importer of importersOf(path, files, imports)) {
      const beside = importer.replace(/\.tsx?$/, '.test$&');
      if (isTest(importer)) found.add(importer);
      else for (const name of [beside, `${beside}x`]) if (files.has(name)) found.add(name);
    }
  }
  return [...found].sort();
}

/**
 * @param {string} path
 * @param {ReadonlyMap<string, string>} files
 * @param {import('./importCircles.mjs').ImportGraph} imports
 */
function importersOf(path, files, imports) {
  if (files.has(path))
    return [...imports]
      .filter(([, each]) => each.static.includes(path) || each.fetched.includes(path))
      .map(([from]) => from);
  const name = `/${basename(path)}`;
  return [...files]
    .filter(([, text]) => text.includes(`${name}?raw`) || text.includes(`${name}'`))
    .map(([from]) => from);
}
