import { createHash } from 'node:crypto';
import { readdirSync, readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';

/** Maximum size (bytes) of a file that is fetched before it is used; the page's own scripts have no limit. */
const KEPT = 800_000;

/** Files that are fetched only once they are used, or the app was installed: exports' players, pictures of the docs and of the library. */
const LATE = /^(farol-player|library\/|screenshots\/)/;

const icon = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="-4 -4 24 24"><path fill="#15191f" d="M-4-4h24v24H-4z"/><path fill="#ffb454" d="M8 1 4 4l1 6h6l1-6zM7 10h2v5H7z"/></svg>`;

const source = (/** @type {string} */ name) => readFileSync(new URL(`offline/${name}`, import.meta.url), 'utf8');

/**
 * Vite plugin: makes a built app one that can be installed, works without a network, and says when another version is there.
 *
 * @param {object} options
 * @param {string} options.name - 'Farol editor'
 * @param {string} [options.opens] - ending of files that the system opens by it: '.farol'
 * @returns {import('vite').Plugin}
 */
export function offlineApp({ name, opens }) {
  /** @type {Map<string, { size: number, hash: string }>} */
  const shared = new Map();
  const hashOf = (/** @type {string | Uint8Array} */ bytes) => createHash('sha256').update(bytes).digest('hex');
  const manifest = {
    ...{ name, short_name: name, start_url: './', scope: './', display: 'standalone' },
    ...{ background_color: '#15191f', theme_color: '#15191f' },
    icons: [{ src: 'icon.svg', sizes: 'any', type: 'image/svg+xml', purpose: 'any' }],
    ...(opens
      ? {
          file_handlers: [{ action: './', accept: { 'application/octet-stream': [opens] } }],
          launch_handler: { client_mode: 'focus-existing' },
        }
      : {}),
  };
  return {
    name: 'farol-offline-app',
    apply: 'build',
    enforce: 'post',
    configResolved({ publicDir }) {
      if (!publicDir) return;
      for (const entry of readdirSync(publicDir, { recursive: true, encoding: 'utf8' })) {
        const path = join(publicDir, entry);
        if (!statSync(path).isFile()) continue;
        const bytes = readFileSync(path);
        shared.set(entry.replaceAll('\\', '/'), { size: bytes.length, hash: hashOf(bytes) });
      }
    },
    transformIndexHtml(_html, { path }) {
      if (path !== '/index.html') return [];
      return [
        { tag: 'link', attrs: { rel: 'manifest', href: './manifest.webmanifest' } },
        { tag: 'script', attrs: { type: 'module', src: './offline.js' }, injectTo: 'body' },
      ];
    },
    generateBundle: {
      order: 'post',
      handler(_options, bundle) {
        const files = new Map(shared);
        const add = (/** @type {string} */ fileName, /** @type {string | Uint8Array} */ bytes) =>
          files.set(fileName, { size: bytes.length, hash: hashOf(bytes) });
        for (const [fileName, output] of Object.entries(bundle)) {
          add(fileName, output.type === 'chunk' ? output.code : output.source);
        }
        const own = {
          'icon.svg': icon,
          'manifest.webmanifest': JSON.stringify(manifest),
          'offline.js': source('page.js'),
        };
        for (const [fileName, text] of Object.entries(own)) {
          add(fileName, text);
          this.emitFile({ type: 'asset', fileName, source: text });
        }
        const all = [...files.keys()].filter((each) => !each.endsWith('.map')).toSorted();
        const first = new Set(Object.keys(bundle).filter((each) => 'isEntry' in bundle[each] && bundle[each].isEntry));
        for (const each of first) for (const name of /** @type {any} */ (bundle[each]).imports ?? []) first.add(name);
        const isKept = (/** @type {string} */ each) =>
          first.has(each) || (!LATE.test(each) && (files.get(each)?.size ?? 0) <= KEPT);
        const kept = all.filter(isKept);
        const version = hashOf(
          [...files]
            .map(([each, { hash }]) => `${each} ${hash}`)
            .toSorted()
            .join(),
        ).slice(0, 16);
        const list = JSON.stringify({ app: name, version, kept, all });
        this.emitFile({ type: 'asset', fileName: 'sw.js', source: `const FILES = ${list};\n${source('worker.js')}` });
      },
    },
  };
}
