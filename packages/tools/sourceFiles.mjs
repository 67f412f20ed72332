import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { root } from './root.mjs';

/**
 * TypeScript files of the repository: packages, apps and browser tests.
 *
 * @returns {Map<string, string>} source by path from the repository's root, with `/`
 */
export function sourceFiles() {
  const files = new Map();
  for (const top of ['packages', 'apps', 'e2e']) {
    for (const name of readdirSync(join(root, top), { recursive: true, encoding: 'utf8' })) {
      const path = `${top}/${name.replaceAll('\\', '/')}`;
      if (!/\.tsx?$/.test(path) || /\/(node_modules|dist)\//.test(path)) continue;
      files.set(path, readFileSync(join(root, path), 'utf8'));
    }
  }
  return files;
}
