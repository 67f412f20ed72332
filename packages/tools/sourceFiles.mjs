import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { root } from './root.mjs';

/**
 * TypeScript files of the repository: packages, apps and browser tests.
 *
 * @returns {Map<string, string>} source by path from the repository's root, with `/`
 */
export function sourceFiles() {
  return new Map(filesEnding('.ts', '.tsx').map((path) => [path, readFileSync(join(root, path), 'utf8')]));
}

/** Folders that are not entered: a build beside the tests empties them while they are read. */
const notSource = new Set(['node_modules', 'dist', '.cache']);

/**
 * Files of packages, apps and browser tests, without what is installed or built.
 *
 * @param {...string} endings - of their names, '' for all files
 * @returns {string[]} paths from the repository's root, with `/`
 */
export function filesEnding(...endings) {
  /** @type {(folder: string) => string[]} */
  const filesOf = (folder) =>
    readdirSync(join(root, folder), { withFileTypes: true }).flatMap((entry) => {
      const path = `${folder}/${entry.name}`;
      if (entry.isDirectory()) return notSource.has(entry.name) ? [] : filesOf(path);
      return endings.some((ending) => path.endsWith(ending)) ? [path] : [];
    });
  return ['packages', 'apps', 'e2e'].flatMap(filesOf);
}
