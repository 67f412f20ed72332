import { dirname, join } from 'node:path/posix';
import { importsOf, targetOf } from './importsOf.mjs';

/** Entry of the renderer: all that it imports by value, directly or not, is the core chunk. */
const entry = 'packages/renderer/src/index.ts';

/**
 * Checks that code which is fetched late stays out of the core chunk. Fetched late is a file that `import()` names, and
 * each file of its folder that it imports by value, directly or not: others import types of it only.
 *
 * @param {ReadonlyMap<string, string>} files - source by path from the repository's root, with `/`
 * @returns {string[]} one line a file that is both, with the way from the entry to it; empty when all is well
 */
export function coreViolations(files) {
  const folder = `${dirname(entry)}/`;
  const imports = new Map(
    [...files]
      .filter(([path]) => path.startsWith(folder) && !/\.(test|bench)\.ts$/.test(path))
      .map(([path, source]) => [path, importsOf(path, source)]),
  );
  /** @type {(path: string, kind: 'value' | 'fetched') => string[]} */
  const targets = (path, kind) =>
    (imports.get(path) ?? [])
      .filter((each) => each.kind === kind && each.specifier.startsWith('.'))
      .flatMap(({ specifier }) => targetOf(join(dirname(path), specifier), imports) ?? []);
  const core = reached(entry, (path) => targets(path, 'value'));
  const violations = new Set();
  for (const path of imports.keys()) {
    for (const fetched of targets(path, 'fetched')) {
      const home = `${dirname(fetched)}/`;
      const late = reached(fetched, (each) => targets(each, 'value').filter((target) => target.startsWith(home)));
      for (const file of late.keys()) {
        if (core.has(file))
          violations.add(
            `${file} is fetched late by ${path}, and in the core chunk: ${wayTo(file, core).join(' -> ')}`,
          );
      }
    }
  }
  return [...violations];
}

/**
 * @param {string} start
 * @param {(path: string) => string[]} next
 * @returns {Map<string, string | null>} all that is reached from the start, each with the one before it
 */
function reached(start, next) {
  /** @type {Map<string, string | null>} */
  const before = new Map([[start, null]]);
  // iteration of a Map includes entries added meanwhile
  for (const path of before.keys()) for (const to of next(path)) if (!before.has(to)) before.set(to, path);
  return before;
}

/** @param {string} path @param {Map<string, string | null>} before @returns {string[]} */
function wayTo(path, before) {
  const from = before.get(path);
  return from == null ? [path] : [...wayTo(from, before), path];
}
