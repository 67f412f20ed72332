import { join } from 'node:path';
import { addressFile } from './appAddresses.mjs';
import { serveFolder } from './benchServe.mjs';
import { root } from './root.mjs';

/** Folders of what can be served. `pages` holds the browser tests' own pages. */
export const appFolders = { editor: 'apps/editor', viewer: 'apps/viewer', lab: 'apps/lab', pages: 'e2e/pages' };

/** @typedef {keyof typeof appFolders} AppName */

/**
 * Serves apps, each on its own port of this machine only: their sources by Vite, or what was built by Node alone. Each finds
 * the others by `apps.json`.
 *
 * @param {object} options
 * @param {Partial<Record<AppName, number>>} options.ports - which apps, and on which port; 0 picks a free one
 * @param {boolean} [options.built] - serve what `npm run build` made, or what lies in the folder that FAROL_BUILT names, not the
 *   sources; default false
 * @param {boolean} [options.watch] - follow edits of the sources (hot reload); default true
 * @returns {Promise<{ urls: Partial<Record<AppName, string>>, close(): Promise<void> }>} URLs end in a slash
 * @throws {Error} when a port is taken
 */
export async function serveApps({ ports, built = false, watch = true }) {
  /** @type {Partial<Record<AppName, string>>} */
  const urls = {};
  /** @type {(() => Promise<void>)[]} */
  const closers = [];
  const addresses = () => JSON.stringify(urls);
  const close = async () => void (await Promise.all(closers.map((closer) => closer())));
  try {
    for (const name of /** @type {AppName[]} */ (Object.keys(ports))) {
      const folder = join(root, appFolders[name]);
      const port = ports[name];
      if (built) {
        const dist = process.env.FAROL_BUILT ? join(process.env.FAROL_BUILT, name) : join(folder, 'dist');
        const { url, close: stop } = await serveFolder(dist, {
          isolated: false,
          port,
          // another build of the Lab, for competitors whose key ends in @against
          beside: name === 'lab' && process.env.FAROL_AGAINST ? { against: process.env.FAROL_AGAINST } : {},
          texts: { [addressFile]: addresses },
        });
        closers.push(stop);
        urls[name] = url;
        continue;
      }
      const { createServer } = await import('vite');
      const server = await createServer({
        root: folder,
        configFile: join(folder, 'vite.config.ts'),
        logLevel: 'warn',
        clearScreen: false,
        plugins: [answerAddresses(addresses)],
        server: { host: '127.0.0.1', port, strictPort: true, ...(watch ? {} : { hmr: false, watch: null }) },
      });
      closers.push(() => server.close());
      await server.listen();
      const address = server.httpServer?.address();
      if (!address || typeof address === 'string') throw new Error(`The server of ${name} has no port.`);
      urls[name] = `http://127.0.0.1:${address.port}/`;
    }
  } catch (error) {
    await close();
    throw error;
  }
  return { urls, close };
}

/**
 * Vite plugin: answers `apps.json`.
 *
 * @param {() => string} addresses
 * @returns {import('vite').Plugin}
 */
function answerAddresses(addresses) {
  return {
    name: 'farol-answer-addresses',
    configureServer({ middlewares }) {
      middlewares.use(`/${addressFile}`, (_request, response) => {
        response.setHeader('content-type', 'application/json');
        response.end(addresses());
      });
    },
  };
}
