import { spawn } from 'node:child_process';
import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { root } from './root.mjs';
import { rivalsDist } from './rivalsPaths.mjs';

const none = { versions: {}, canInstall: false };

/**
 * Content of `rivals/versions.json`: versions by competitor's key, and whether a POST to `rivals/install` installs them.
 *
 * @param {string} [folder] - where their modules lie
 */
export function rivalVersions(folder = rivalsDist) {
  const path = join(folder, 'versions.json');
  /** @type {{ versions: Record<string, string>, canInstall: boolean }} */
  const found = existsSync(path) ? JSON.parse(readFileSync(path, 'utf8')) : none;
  return found;
}

/**
 * Whether a request to install comes from a page of this server: another site's page could send one too.
 *
 * @param {{ method?: string, headers: Record<string, string | string[] | undefined> }} request
 */
export function isOwnRequest({ method, headers }) {
  const { host, origin } = headers;
  return (
    method === 'POST' &&
    typeof origin === 'string' &&
    origin === `http://${host}` &&
    (headers['sec-fetch-site'] ?? 'same-origin') === 'same-origin'
  );
}

/** Runs `npm run rivals`. @returns {Promise<string | null>} the end of what it said when it failed */
function install() {
  return new Promise((resolve) => {
    const tool = spawn(process.execPath, [join(root, 'packages/tools/rivals.mjs')], { cwd: root });
    let said = '';
    for (const stream of [tool.stdout, tool.stderr]) {
      stream.on('data', (/** @type {Buffer} */ part) => {
        process.stdout.write(part);
        said = (said + part.toString()).slice(-2000);
      });
    }
    tool.on('error', ({ message }) => resolve(message));
    tool.on('close', (code) => resolve(code === 0 ? null : said.trim()));
  });
}

/** @type {Promise<string | null> | null} */
let installing = null;

/**
 * Answer of the development server to a request under `rivals/`.
 *
 * @param {string} name - of the file, or `install`
 * @param {Parameters<typeof isOwnRequest>[0]} request
 * @returns {Promise<{ status: number, type: string, body: string | Buffer }>}
 */
async function answer(name, request) {
  const json = 'application/json';
  if (name === 'versions.json') {
    return { status: 200, type: json, body: JSON.stringify({ ...rivalVersions(), canInstall: true }) };
  }
  if (name === 'install') {
    if (!isOwnRequest(request)) return { status: 403, type: json, body: '{}' };
    installing ??= install().finally(() => (installing = null));
    return { status: 200, type: json, body: JSON.stringify({ problem: await installing }) };
  }
  const path = join(rivalsDist, name);
  if (!existsSync(path)) return { status: 404, type: 'text/plain', body: 'Run npm run rivals.' };
  return { status: 200, type: 'text/javascript', body: readFileSync(path) };
}

/**
 * Vite plugin: the Lab's page finds the other engines under `rivals/` when they are installed. The development server
 * installs them when its own page asks; a build takes those along that are there.
 *
 * @returns {import('vite').Plugin}
 */
export function rivals() {
  return {
    name: 'farol-rivals',
    configureServer(server) {
      server.middlewares.use((request, response, next) => {
        const [, name] = /^\/rivals\/([\w-]+(?:\.js|\.json)?)(?:\?|$)/.exec(request.url ?? '') ?? [];
        if (name === undefined) next();
        else
          answer(name, request).then(({ status, type, body }) => {
            response.writeHead(status, { 'content-type': type, 'cache-control': 'no-cache' }).end(body);
          }, next);
      });
    },
    generateBundle() {
      const files = existsSync(rivalsDist) ? readdirSync(rivalsDist).filter((name) => /\.(js|txt)$/.test(name)) : [];
      for (const name of files) {
        this.emitFile({ type: 'asset', fileName: `rivals/${name}`, source: readFileSync(join(rivalsDist, name)) });
      }
      const source = JSON.stringify(rivalVersions());
      this.emitFile({ type: 'asset', fileName: 'rivals/versions.json', source });
    },
  };
}
