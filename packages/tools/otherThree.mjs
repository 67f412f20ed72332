import { existsSync, readFileSync } from 'node:fs';
import { basename, join } from 'node:path';

/** Prefix of the ids of modules that this version of three does not have: their classes throw when they are used. */
const MISSING = '\0farol-missing:';

/**
 * A Vite plugin that has `three` and all of `three/…` come from another folder than the page's own: for `npm run
 * compat`. Vite's own resolution is not asked: `resolve.dedupe` would find the three of the repository whoever imports
 * it.
 *
 * @param {string} folder - a folder whose node_modules holds the three to take
 * @returns {import('vite').Plugin}
 */
export function otherThree(folder) {
  const three = join(folder, 'node_modules/three');
  /** @type {{ exports: Record<string, string | { import: string }> }} */
  const { exports } = JSON.parse(readFileSync(join(three, 'package.json'), 'utf8'));
  return {
    name: 'farol-other-three',
    enforce: 'pre',
    resolveId(source) {
      const path = threePath(source, exports);
      if (path === null) return null;
      const file = join(three, path);
      return existsSync(file) ? file : `${MISSING}${source}`;
    },
    load(id) {
      if (!id.startsWith(MISSING)) return null;
      const source = id.slice(MISSING.length);
      return `export class ${basename(source, '.js')} {
        constructor() { throw new Error(${JSON.stringify(`${source} is not part of this three.`)}); }
      }`;
    },
  };
}

/**
 * Resolves an import of three to a file.
 *
 * @param {string} source - what is imported
 * @param {Record<string, string | { import: string }>} exports - of three's package.json
 * @returns {string | null} path in three's folder; null for another package's module
 * @throws {Error} when this three does not export it
 */
export function threePath(source, exports) {
  if (source !== 'three' && !source.startsWith('three/')) return null;
  const entry = `.${source.slice('three'.length)}`;
  for (const [name, target] of Object.entries(exports)) {
    const file = typeof target === 'string' ? target : target.import;
    if (name === entry) return file;
    const [head, tail] = name.split('*');
    if (tail !== undefined && entry.startsWith(head)) return file.replace('*', entry.slice(head.length));
  }
  throw new Error(`This three does not export ${source}.`);
}
