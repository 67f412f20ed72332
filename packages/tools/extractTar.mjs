import { gunzipSync } from 'node:zlib';

const BLOCK = 512;

/**
 * Files of a gzipped tar archive as `npm pack` writes it (ustar).
 *
 * @param {Buffer} archive
 * @param {(path: string) => boolean} take
 * @returns {{ path: string, bytes: Buffer }[]}
 */
export function extractTar(archive, take) {
  const tar = gunzipSync(archive);
  const files = [];
  for (let at = 0; at + BLOCK <= tar.length && tar[at] !== 0;) {
    const text = (/** @type {number} */ from, /** @type {number} */ length) =>
      tar.toString('utf8', at + from, at + from + length).split('\0')[0];
    const prefix = text(345, 155);
    const path = prefix ? `${prefix}/${text(0, 100)}` : text(0, 100);
    const size = parseInt(text(124, 12).trim() || '0', 8);
    const isFile = text(156, 1) === '0' || text(156, 1) === '';
    if (isFile && take(path)) files.push({ path, bytes: tar.subarray(at + BLOCK, at + BLOCK + size) });
    at += BLOCK + Math.ceil(size / BLOCK) * BLOCK;
  }
  return files;
}
