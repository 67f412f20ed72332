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
  /** `import { type X }` is of values: it loads the module. @returns {ImportKind} */
  const kindOf = (/** @type {{ start: number }} */ { start }) =>
    /^(import|export)\s+type\b/.test(source.slice(start, start + 20)) ? 'type' : 'value';
  return [
    ...module.staticImports.map((each) => ({ specifier: each.moduleRequest.value, kind: kindOf(each) })),
    ...module.staticExports.flatMap((statement) =>
      statement.entries.flatMap(({ moduleRequest }) =>
        moduleRequest ? [{ specifier: moduleRequest.value, kind: kindOf(statement) }] : [],
      ),
    ),
    ...module.dynamicImports.flatMap(({ moduleRequest: { start, end } }) => {
      const specifier = /^['"](.*)['"]$/.exec(source.slice(start, end))?.[1];
      return specifier === undefined ? [] : [{ specifier, kind: /** @type {const} */ ('fetched') }];
    }),
  ];
}

/**
 * Resolves a relative import to a file.
 *
 * @param {string} path - joined; its ending may be left out
 * @param {ReadonlyMap<string, unknown>} files - by path
 * @returns {string | undefined} undefined for what is no such file, such as a shader
 */
export function targetOf(path, files) {
  const target = path.replace(/\/$/, '');
  const ending = ['', '.ts', '.tsx', '.mjs', '/index.ts', '/index.tsx'].find((each) => files.has(target + each));
  return ending === undefined ? undefined : target + ending;
}
