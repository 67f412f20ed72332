import { randomBytes } from 'node:crypto';
import { join } from 'node:path';
import { addressFile } from './appAddresses.mjs';
import { serveFolder } from './benchServe.mjs';
import { livePath } from './reach/livePath.mjs';
import { root } from './root.mjs';

/** Folders of what can be served. `pages` holds the browser tests' own pages. */
export const appFolders = {
  editor: 'apps/editor',
  viewer: 'apps/viewer',
  lab: 'apps/lab',
  site: 'apps/site',
  /** Live modules of the site, without its pages. */
  live: 'apps/site/live',
  pages: 'e2e/pages',
};

/** @typedef {keyof typeof appFolders} AppName */
/** @typedef {Partial<Record<AppName, string>>} AppUrls */

/**
 * Serves apps, each on its own port of this machine only: their sources by Vite, or what was built by Node alone. Each finds
 * the others by `apps.json`.
 *
 * @param {object} options
 * @param {Partial<Record<AppName, number>>} options.ports - which apps, and on which port; 0 picks a free one
 * @param {boolean} [options.built] - serve what `npm run build` made, or what lies in the folder that FAROL_BUILT names, not the
 *   sources; default false
 * @param {boolean} [options.watch] - follow edits of the sources (hot reload); default true
 * @param {Partial<Record<AppName, number>>} [options.network] - ports at which sources are served to the network as well:
 *   over HTTPS, to those who have the token; default none
 * @param {readonly import('vite').Plugin[]} [options.plugins] - added to those of each app that is served from source
 * @param {readonly string[]} [options.hosts] - addresses of this machine; those in its networks when absent
 * @returns {Promise<{ urls: AppUrls, networkUrls: AppUrls[], agentKey: string, close(): Promise<void> }>} URLs end in a slash,
 *   those of the network, one record for each of `hosts`, in a token; `agentKey` is the secret of agents (`@farol/mcp`)
 * @throws {Error} when a port is taken
 */
export async function serveApps({ ports, built = false, watch = true, network = {}, plugins = [], hosts }) {
  /** @type {AppUrls} */
  const urls = {};
  /** @type {Partial<Record<AppName, number>>} */
  const networkPorts = {};
  /** @type {(() => Promise<void>)[]} */
  const closers = [];
  const reach = Object.keys(network).length > 0 ? await import('./reach/networkServer.mjs') : null;
  const { LiveRelay } = await import('./reach/liveRelay.mjs');
  const agentKey = randomBytes(24).toString('base64url');
  const relay = new LiveRelay(agentKey);
  relay.onProblem = console.warn;
  closers.push(async () => relay.close());
  const token = randomBytes(12).toString('base64url');
  const places = reach ? (hosts ?? reach.networkAddresses()) : [];
  /** @param {string} host @param {string} [end] @returns {AppUrls} */
  const urlsOf = (host, end = '') =>
    Object.fromEntries(Object.entries(networkPorts).map(([name, port]) => [name, `https://${host}:${port}/${end}`]));
  /** Addresses of the apps; `phone` are those of the page that looks at the editor's scene, `agent` is the script of the MCP server. @param {import('node:http').IncomingMessage} [request] */
  const addresses = (request) =>
    JSON.stringify({
      ...urls,
      ...(urls.site ? { gallery: `${urls.site}gallery/` } : {}),
      ...(request && 'encrypted' in request.socket
        ? urlsOf(String(request.headers.host).replace(/:\d+$/, ''))
        : { agent: join(root, 'packages/tools/mcp.mjs') }),
      ...(networkPorts.editor ? { phone: places.map((host) => urlsOf(host, `live.html?token=${token}`).editor) } : {}),
    });
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
          upgrade: upgradeBy(relay),
        });
        closers.push(stop);
        urls[name] = url;
        continue;
      }
      if (name === 'site') {
        const { serveSite } = await import('./site/liveServer.mjs');
        const { url, close: stop } = await serveSite(port ?? 0, () => JSON.stringify(urls));
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
        plugins: [...plugins, answerAddresses(addresses), relayPlugin(relay)],
        server: { host: '127.0.0.1', port, strictPort: true, ...(watch ? {} : { hmr: false, watch: null }) },
      });
      closers.push(() => server.close());
      await server.listen();
      const address = server.httpServer?.address();
      if (!address || typeof address === 'string') throw new Error(`The server of ${name} has no port.`);
      urls[name] = `http://127.0.0.1:${address.port}/`;
      const networkPort = network[name];
      if (!reach || networkPort === undefined) continue;
      const front = await reach.serveToNetwork({ app: server, relay, token, port: networkPort, host: hosts?.[0] });
      closers.push(front.close);
      networkPorts[name] = front.port;
    }
  } catch (error) {
    await close();
    throw error;
  }
  return { urls, networkUrls: places.map((host) => urlsOf(host, `?token=${token}`)), agentKey, close };
}

/**
 * Vite plugin: answers the relay of live edits, also to this machine's own pages.
 *
 * @param {import('./reach/liveRelay.mjs').LiveRelay} relay
 * @returns {import('vite').Plugin}
 */
function relayPlugin(relay) {
  return {
    name: 'farol-live-relay',
    configureServer({ middlewares, httpServer }) {
      middlewares.use((request, response, next) => relay.answer(request, response, next));
      httpServer?.on('upgrade', upgradeBy(relay));
    },
  };
}

/**
 * Listener that opens the relay's WebSockets and leaves others alone.
 *
 * @param {import('./reach/liveRelay.mjs').LiveRelay} relay
 * @returns {(request: import('node:http').IncomingMessage, socket: import('node:stream').Duplex, head: Buffer) => void}
 */
const upgradeBy = (relay) => (request, socket, head) => {
  if (request.url?.startsWith(livePath)) relay.upgrade(request, socket, head);
};

/**
 * Vite plugin: answers `apps.json`.
 *
 * @param {(request: import('node:http').IncomingMessage) => string} addresses
 * @returns {import('vite').Plugin}
 */
function answerAddresses(addresses) {
  return {
    name: 'farol-answer-addresses',
    configureServer({ middlewares }) {
      middlewares.use(`/${addressFile}`, (request, response) => {
        response.setHeader('content-type', 'application/json');
        response.end(addresses(request));
      });
    },
  };
}
