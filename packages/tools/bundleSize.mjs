import { readFileSync } from 'node:fs';
import { dirname, join, normalize } from 'node:path/posix';
import { gzipSync } from 'node:zlib';
import { importsOf } from './importsOf.mjs';

/**
 * Bytes that the core of @farol/renderer may take: minified, gzipped, three left out. What renderer/lazyCode.ts fetches
 * when a scene or setting first asks for it is not counted.
 */
export const rendererLimit = 50_900;

/** Bytes that the editor's script may take before its first frame; panels, dialogs and loaders come on demand. */
export const editorLimit = 409_200;

/** Bytes that the script of the Lab's page may take, charts included; what is measured is in `stage.html`. */
export const labLimit = 150_000;

/**
 * Bytes of an entry of a built package after gzip: the file and all that it imports of the package at start, each file by
 * itself as a server would send it. What only other entries import, or what is imported late, is not counted.
 *
 * @param {string} folder - its dist
 * @param {string} entry - file in it, with `/`
 * @throws {Error} when a file is missing: a package that was not built is not small
 */
export function bundleSize(folder, entry = 'index.js') {
  /** @type {Map<string, number>} */
  const sizes = new Map();
  const add = (/** @type {string} */ file) => {
    if (sizes.has(file)) return;
    const source = read(join(folder, file));
    sizes.set(file, gzipSync(source, { level: 9 }).length);
    for (const { specifier, kind } of importsOf(file, source))
      if (kind === 'value' && specifier.startsWith('.')) add(normalize(join(dirname(file), specifier)));
  };
  add(entry);
  return [...sizes.values()].reduce((sum, size) => sum + size, 0);
}

/**
 * Bytes of the script of a built page, as {@link bundleSize} counts them.
 *
 * @param {string} folder - its dist
 * @param {string} page - file in it
 * @throws {Error} when the page is missing or names no script
 */
export function scriptSize(folder, page = 'index.html') {
  const [, entry] = /<script type="module"[^>]* src="\.\/([^"]+)"/.exec(read(join(folder, page))) ?? [];
  if (!entry) throw new Error(`${join(folder, page)} names no script: see what Vite made of it.`);
  return bundleSize(folder, entry);
}

/** @param {string} file */
function read(file) {
  try {
    return readFileSync(file, 'utf8');
  } catch (error) {
    throw new Error(`${file} is not there: build the package first.`, { cause: error });
  }
}
