import { join } from 'node:path';
import { root } from './root.mjs';

/** Folders of what can be served. `pages` holds the browser tests' own pages. */
export const appFolders = { editor: 'apps/editor', viewer: 'apps/viewer', pages: 'e2e/pages' };

/** @typedef {keyof typeof appFolders} AppName */

/**
 * Serves apps by Vite, each on its own port of this machine only.
 *
 * @param {object} options
 * @param {Partial<Record<AppName, number>>} options.ports which apps, and on which port; 0 picks a free one
 * @param {boolean} [options.built] serve what `npm run build` made, not the sources; default false
 * @param {boolean} [options.watch] follow edits of the sources (hot reload); default true
 * @returns {Promise<{ urls: Partial<Record<AppName, string>>, close(): Promise<void> }>} URLs end in a slash
 * @throws {Error} when a port is taken
 */
export async function serveApps({ ports, built = false, watch = true }) {
  const { createServer, preview } = await import('vite');
  /** @type {Partial<Record<AppName, string>>} */
  const urls = {};
  /** @type {(() => Promise<void>)[]} */
  const closers = [];
  const close = async () => void (await Promise.all(closers.map((closer) => closer())));
  try {
    for (const name of /** @type {AppName[]} */ (Object.keys(ports))) {
      const folder = join(root, appFolders[name]);
      const port = ports[name];
      /** @type {import('vite').InlineConfig} */
      const config = { root: folder, configFile: join(folder, 'vite.config.ts'), logLevel: 'warn', clearScreen: false };
      const host = '127.0.0.1';
      const server = built
        ? await preview({ ...config, preview: { host, port, strictPort: true } })
        : await createServer({
            ...config,
            server: { host, port, strictPort: true, ...(watch ? {} : { hmr: false, watch: null }) },
          });
      closers.push(() => server.close());
      if ('listen' in server) await server.listen();
      const address = server.httpServer?.address();
      if (!address || typeof address === 'string') throw new Error(`The server of ${name} has no port.`);
      urls[name] = `http://${host}:${address.port}/`;
    }
  } catch (error) {
    await close();
    throw error;
  }
  return { urls, close };
}
