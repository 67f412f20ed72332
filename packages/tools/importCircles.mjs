import { dirname, join } from 'node:path/posix';
import { parseSync } from 'vite';
import { importsOf, targetOf } from './importsOf.mjs';

/**
 * Targets by path and kind of import. `types`: by `import type`, `export type` and `import('./X').T`, which are gone at run time;
 * `import { type X }` is a value, since it loads the module. `fetched`: by `import('./X')` at run time.
 *
 * @typedef {ReadonlyMap<string, { static: string[], types: string[], fetched: string[] }>} ImportGraph
 */

/**
 * Finds the imports of each file that lead to others of the set.
 *
 * @param {ReadonlyMap<string, string>} files - source by path from the repository's root, with `/`
 * @returns {ImportGraph}
 */
export function importGraph(files) {
  return new Map([...files].map(([path, source]) => [path, targetsOf(path, source, files)]));
}

/**
 * Finds import circles: the largest sets of files each of which imports each other one, directly or through others of the
 * set.
 *
 * @param {ImportGraph} imports
 * @param {'static' | 'fetched' | 'types'} kind - 'fetched' and 'types' count static imports too
 * @returns {string[][]} paths in alphabetical order, the largest circle first; a file that imports itself is a circle of one
 */
export function importCircles(imports, kind) {
  const graph = new Map(
    [...imports].map(([path, each]) => [path, kind === 'static' ? each.static : [...each.static, ...each[kind]]]),
  );
  return stronglyConnected(graph)
    .filter(([first, ...others]) => others.length > 0 || graph.get(first)?.includes(first))
    .map((circle) => circle.toSorted())
    .toSorted((a, b) => b.length - a.length || a[0].localeCompare(b[0]));
}

/**
 * Circles that types close and that are not within one folder of a workspace's sources, such as `packages/engine/src/core`:
 * folders are in an order, files of one folder may name each other's types.
 *
 * @param {string[][]} circles - as {@link importCircles} gives them
 * @returns {string[]} one line a circle; empty when all is well
 */
export function circlesAcrossFolders(circles) {
  return circles.flatMap((circle) => {
    const folders = new Set(circle.map((path) => /^.*?\/src\/[^/]+(?=\/)/.exec(path)?.[0] ?? dirname(path)));
    return folders.size > 1 ? [`a circle over ${[...folders].join(', ')}: ${circle.join(', ')}`] : [];
  });
}

/**
 * Files of the set that a file imports.
 *
 * @param {string} path @param {string} source @param {ReadonlyMap<string, string>} files
 * @returns {{ static: string[], types: string[], fetched: string[] }}
 */
function targetsOf(path, source, files) {
  const imports = importsOf(path, source).filter(({ specifier }) => specifier.startsWith('.'));
  const named = (/** @type {import('./importsOf.mjs').ImportKind} */ kind) =>
    imports.filter((each) => each.kind === kind).map(({ specifier }) => specifier);
  const resolved = (/** @type {string[]} */ specifiers) =>
    specifiers.flatMap((specifier) => targetOf(join(dirname(path), specifier), files) ?? []);
  const fetched = named('fetched');
  // making and walking the tree is slow: only where there is an import() that fetches nothing
  const isAllFetched = [...source.matchAll(/\bimport\(\s*['"]\./g)].length <= fetched.length;
  const ofTypes = isAllFetched ? [] : importTypesOf(parseSync(path, source).program);
  return {
    static: resolved(named('value')),
    types: resolved([...named('type'), ...ofTypes.filter((specifier) => specifier.startsWith('.'))]),
    fetched: resolved(fetched),
  };
}

/** Specifiers of `import('./X').T` used as a type. @param {unknown} node @returns {string[]} */
function importTypesOf(node) {
  if (Array.isArray(node)) return node.flatMap(importTypesOf);
  if (typeof node !== 'object' || node === null) return [];
  const { type, source } = /** @type {{ type?: string, source?: { value: string } }} */ (node);
  const own = type === 'TSImportType' && source ? [source.value] : [];
  return [...own, ...Object.values(node).flatMap(importTypesOf)];
}

/**
 * Strongly connected components of a graph.
 *
 * @param {ReadonlyMap<string, readonly string[]>} graph - targets by node
 * @returns {string[][]}
 * @see Tarjan 1972, Depth-first search and linear graph algorithms
 */
function stronglyConnected(graph) {
  /** @type {string[][]} */
  const components = [];
  /** @type {Map<string, { index: number, low: number, isOpen: boolean }>} */
  const visits = new Map();
  /** @type {string[]} */
  const stack = [];
  const visit = (/** @type {string} */ node) => {
    const own = { index: visits.size, low: visits.size, isOpen: true };
    visits.set(node, own);
    stack.push(node);
    for (const target of graph.get(node) ?? []) {
      const other = visits.get(target) ?? visit(target);
      if (other.isOpen) own.low = Math.min(own.low, other.low);
    }
    if (own.low === own.index) {
      const component = stack.splice(stack.indexOf(node));
      for (const each of component) /** @type {{ isOpen: boolean }} */ (visits.get(each)).isOpen = false;
      components.push(component);
    }
    return own;
  };
  for (const node of graph.keys()) if (!visits.has(node)) visit(node);
  return components;
}
