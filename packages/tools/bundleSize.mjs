import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';

/** Bytes that @farol/renderer may take: minified, gzipped, three left out. */
export const rendererLimit = 45_000;

/**
 * Bytes of all JavaScript of a built package after gzip, each file by itself as a server would send it.
 *
 * @param {string} folder its dist
 * @throws {Error} when there is no JavaScript: a package that was not built is not small
 */
export function bundleSize(folder) {
  const files = readdirSync(folder, { recursive: true, encoding: 'utf8' }).filter((name) => name.endsWith('.js'));
  if (files.length === 0) throw new Error(`${folder} holds no JavaScript: build the package first.`);
  return files.reduce((sum, name) => sum + gzipSync(readFileSync(join(folder, name)), { level: 9 }).length, 0);
}
