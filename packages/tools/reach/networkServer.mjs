import { mkdir } from 'node:fs/promises';
import { createServer } from 'node:https';
import { networkInterfaces } from 'node:os';
import { join } from 'node:path';
import { getCertificate } from '@vitejs/plugin-basic-ssl';
import { root } from '../root.mjs';
import { livePath } from './livePath.mjs';
import { isOwnOrigin, isSecret, refuse } from './liveRelay.mjs';

/** Name of the cookie that holds the token, once an address with it was opened. */
const COOKIE = 'farol-token';

/** Days that the certificate holds: browsers take none that holds for more than 398. */
const DAYS = 365;

/** IPv4 addresses of this machine in its networks. */
export const networkAddresses = () =>
  Object.values(networkInterfaces()).flatMap((each) =>
    (each ?? []).filter(({ family, internal }) => family === 'IPv4' && !internal).map(({ address }) => address),
  );

/**
 * Whether a request has the token: in its address, or in the cookie that an address with it leaves.
 *
 * @param {import('node:http').IncomingMessage} request
 * @param {string} token
 * @returns {'address' | 'cookie' | null} where it has it
 */
export function tokenIn({ url, headers }, token) {
  if (isSecret(new URLSearchParams((url ?? '').split('?')[1]).get('token'), token)) return 'address';
  const cookies = (headers.cookie ?? '').split(/; */).map((each) => each.split('='));
  return cookies.some(([name, value]) => name === COOKIE && isSecret(value, token)) ? 'cookie' : null;
}

/**
 * Serves an app of Vite's, which itself answers this machine alone, to the network: over HTTPS by a certificate of this
 * machine's own, kept in `.cache`, and only to those who have the token.
 *
 * @param {object} options
 * @param {import('vite').ViteDevServer} options.app
 * @param {import('./liveRelay.mjs').LiveRelay} options.relay
 * @param {string} options.token
 * @param {number} options.port - 0 picks a free one
 * @param {string} [options.host] - interface; default all of them
 * @returns {Promise<{ port: number, close(): Promise<void> }>}
 * @throws {Error} when the port is taken
 */
export async function serveToNetwork({ app, relay, token, port, host = '0.0.0.0' }) {
  const folder = join(root, '.cache', 'https');
  // the file holds the private key
  await mkdir(folder, { recursive: true, mode: 0o700 });
  const certificate = await getCertificate(folder, 'Farol on this machine', [], DAYS);
  const server = createServer({ cert: certificate, key: certificate }, (request, response) => {
    const place = tokenIn(request, token);
    if (!place) {
      response.writeHead(403, { 'content-type': 'text/plain; charset=utf-8' });
      return void response.end('This address needs its token: open the whole address that npm start printed.\n');
    }
    if (place === 'address')
      response.setHeader('set-cookie', `${COOKIE}=${token}; Path=/; Secure; HttpOnly; SameSite=Lax`);
    response.setHeader('referrer-policy', 'no-referrer');
    // apps know no such parameter; the phone's page keeps it, so that its address can be handed on
    if (place === 'address' && !request.url?.startsWith('/live.html')) {
      const [path, query] = (request.url ?? '/').split('?');
      const left = new URLSearchParams(query);
      left.delete('token');
      // one slash: two would name another host
      return void response.writeHead(302, { location: `/${path.replace(/^\/+/, '')}?${left}` }).end();
    }
    app.middlewares(request, response);
  });
  server.on('upgrade', (request, socket, head) => {
    if (!tokenIn(request, token) || !isOwnOrigin(request)) return refuse(socket, '403 Forbidden');
    if (request.url?.startsWith(livePath)) relay.upgrade(request, socket, head);
    // Vite's own socket, by which pages follow edits of the sources
    else app.httpServer?.emit('upgrade', request, socket, head);
  });
  await new Promise((done, failed) => {
    server.once('error', failed).listen(port, host, () => done(undefined));
  });
  const address = /** @type {import('node:net').AddressInfo} */ (server.address());
  return {
    port: address.port,
    close: () =>
      new Promise((done) => {
        server.close(() => done());
        server.closeAllConnections();
      }),
  };
}
