import { parseSync } from 'vite';

/**
 * How a module is imported: its values, its types alone, or at run time by `import()`.
 * @typedef {'value' | 'type' | 'fetched'} ImportKind
 */

/** @typedef {{ specifier: string, kind: ImportKind }} Import */

/**
 * All static and dynamic imports and re-exports of a TypeScript file.
 *
 * @param {string} path @param {string} source @returns {Import[]}
 */
export function importsOf(path, source) {
  const { module } = parseSync(path, source);
  const text = (/** @type {{ start: number, end: number }} */ { start, end }) => source.slice(start, end);
  /** @returns {Import} */
  const found = (/** @type {string} */ specifier, /** @type {ImportKind} */ kind) => ({ specifier, kind });
  return [
    ...module.staticImports.map(({ moduleRequest, entries }) =>
      found(moduleRequest.value, entries.length > 0 && entries.every(({ isType }) => isType) ? 'type' : 'value'),
    ),
    ...module.staticExports.flatMap(({ entries }) =>
      entries.flatMap(({ moduleRequest, isType }) =>
        moduleRequest ? [found(moduleRequest.value, isType ? 'type' : 'value')] : [],
      ),
    ),
    ...module.dynamicImports.flatMap(({ moduleRequest }) => {
      const specifier = /^['"](.*)['"]$/.exec(text(moduleRequest))?.[1];
      return specifier === undefined ? [] : [found(specifier, 'fetched')];
    }),
  ];
}

/**
 * Resolves a relative import to a file.
 *
 * @param {string} path - joined, without ending
 * @param {ReadonlyMap<string, unknown>} files - by path
 * @returns {string | undefined} undefined for what is no such file, such as a shader
 */
export function targetOf(path, files) {
  return [path, `${path}.ts`, `${path}.tsx`, `${path}/index.ts`].find((each) => files.has(each));
}
