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

/**
 * Files of packages, apps and browser tests, without what is installed or built.
 *
 * @param {...string} endings of their names, '' for all files
 * @returns {string[]} paths from the repository's root, with `/`
 */
export function filesEnding(...endings) {
  return ['packages', 'apps', 'e2e'].flatMap((top) =>
    readdirSync(join(root, top), { recursive: true, encoding: 'utf8' })
      .map((name) => `${top}/${name.replaceAll('\\', '/')}`)
      .filter((path) => endings.some((ending) => path.endsWith(ending)) && !/\/(node_modules|dist)\//.test(path)),
  );
}
