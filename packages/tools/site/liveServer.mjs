import { join } from 'node:path';
import { addressFile } from '../appAddresses.mjs';
import { root } from '../root.mjs';

/** Folder of the site's live modules: a build of its own, by the repository's Vite. */
export const liveFolder = join(root, 'apps/site/live');

/**
 * Plugin of VitePress's Vite: serves the live modules from source, by the repository's Vite, under `/live/`.
 *
 * @returns {import('vite').Plugin}
 */
export function liveServer() {
  return {
    name: 'farol-live-server',
    apply: 'serve',
    async configureServer(site) {
      const { createServer } = await import('vite');
      const live = await createServer({
        root: liveFolder,
        configFile: join(liveFolder, 'vite.config.ts'),
        base: '/live/',
        logLevel: 'warn',
        clearScreen: false,
        server: { middlewareMode: true, hmr: false },
        appType: 'mpa',
      });
      site.httpServer?.on('close', () => void live.close());
      site.middlewares.use((request, response, next) =>
        request.url?.startsWith('/live/') ? live.middlewares(request, response, next) : next(),
      );
    },
  };
}

/**
 * Serves the site from source to this machine only.
 *
 * @param {number} port - 0 picks a free one
 * @param {() => string} addresses - content of `apps.json`, the addresses of the other apps
 * @returns {Promise<{ url: string, close(): Promise<void> }>} the URL ends in a slash
 */
export async function serveSite(port, addresses) {
  const { createServer } = await import('vitepress');
  const server = await createServer(join(root, 'apps/site'), { host: '127.0.0.1', port, strictPort: true });
  // before VitePress, which answers all paths
  server.middlewares.stack.unshift({
    route: `/${addressFile}`,
    handle: (/** @type {unknown} */ _request, /** @type {import('node:http').ServerResponse} */ response) => {
      response.setHeader('content-type', 'application/json');
      response.end(addresses());
    },
  });
  await server.listen();
  const address = server.httpServer?.address();
  if (!address || typeof address === 'string') throw new Error('The server of the site has no port.');
  return { url: `http://127.0.0.1:${address.port}/`, close: () => server.close() };
}
