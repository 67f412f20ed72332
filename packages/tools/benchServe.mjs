import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import { extname, join, normalize, resolve, sep } from 'node:path';
import { frameHeaders } from './contentSecurityPolicy.mjs';

/** @type {Record<string, string>} */
const types = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript',
  '.mjs': 'text/javascript',
  '.css': 'text/css',
  '.json': 'application/json',
  '.gltf': 'model/gltf+json',
  '.glb': 'model/gltf-binary',
  '.wasm': 'application/wasm',
  '.png': 'image/png',
  '.jpg': 'image/jpeg',
  '.svg': 'image/svg+xml',
  '.webp': 'image/webp',
  '.xml': 'text/xml',
  '.webmanifest': 'application/manifest+json',
};

const isolation = { 'cross-origin-opener-policy': 'same-origin', 'cross-origin-embedder-policy': 'require-corp' };

/**
 * Serves a built app to this machine only, by Node alone.
 *
 * @param {string} folder
 * @param {object} [options]
 * @param {boolean} [options.isolated] - pages are cross-origin isolated, which gives their clock 5 µs in place of 100;
 *   default true
 * @param {number} [options.port] - default 0, a free one
 * @param {Record<string, string>} [options.beside] - folders served under names of their own, `/name/…`
 * @param {Readonly<Record<string, () => string>>} [options.texts] - what answers in place of files, by name: 'apps.json'
 * @param {(request: import('node:http').IncomingMessage, socket: import('node:stream').Duplex, head: Buffer) => void} [options.upgrade] -
 *   opens WebSockets; there are none when absent
 * @returns {Promise<{ url: string, close(): Promise<void> }>} the URL ends in a slash
 */
export async function serveFolder(folder, { isolated = true, port = 0, beside = {}, texts = {}, upgrade } = {}) {
  const tops = Object.entries(beside).map(([name, each]) => ({ prefix: `/${name}/`, top: resolve(each) }));
  tops.push({ prefix: '/', top: resolve(folder) });
  const server = createServer(async (request, response) => {
    try {
      const { pathname } = new URL(request.url ?? '/', 'http://localhost');
      const asked = decodeURIComponent(pathname.endsWith('/') ? `${pathname}index.html` : pathname);
      const { prefix, top } = tops.find(({ prefix }) => asked.startsWith(prefix)) ?? tops[tops.length - 1];
      const path = normalize(join(top, asked.slice(prefix.length)));
      if (!path.startsWith(top + sep)) throw new Error('outside of the folder');
      const body = Object.hasOwn(texts, asked.slice(1)) ? texts[asked.slice(1)]() : await readFile(path);
      response.writeHead(200, {
        'content-type': types[extname(path)] ?? 'application/octet-stream',
        ...frameHeaders(asked),
        ...(isolated ? isolation : {}),
      });
      response.end(body);
    } catch {
      response.writeHead(404).end();
    }
  });
  if (upgrade) server.on('upgrade', upgrade);
  await new Promise((done, failed) => {
    server.once('error', failed).listen(port, '127.0.0.1', () => done(undefined));
  });
  const address = server.address();
  if (!address || typeof address === 'string') throw new Error(`The server of ${folder} has no port.`);
  return {
    url: `http://127.0.0.1:${address.port}/`,
    close: () =>
      new Promise((done) => {
        server.close(() => done());
        server.closeAllConnections();
      }),
  };
}
