import { createServer } from 'vite';
import { serverSourceConditions } from './sourceConditions.mjs';

/**
 * Vite plugin: runs some modules when a page is built or served. The page gets what they export, which must be data, in place
 * of their code and all that they import.
 *
 * @param {...string} ends - how the paths of the modules end, with `/`
 * @returns {import('vite').Plugin}
 */
export function valueModules(...ends) {
  return {
    name: 'farol-value-modules',
    enforce: 'pre',
    async load(id) {
      const [path] = id.split('?');
      if (!ends.some((end) => path.endsWith(end))) return null;
      const exported = Object.entries(await runModule(path));
      return exported.map(([name, value]) => `export const ${name} = ${JSON.stringify(value)};`).join('\n');
    },
  };
}

/** Runs a module in Node, the repository's packages from source. @param {string} id - its path */
export async function runModule(id) {
  const server = await createServer({
    configFile: false,
    appType: 'custom',
    logLevel: 'error',
    optimizeDeps: { noDiscovery: true },
    server: { middlewareMode: true, ws: false, watch: null },
    ssr: { noExternal: [/^@farol\//], resolve: { conditions: serverSourceConditions } },
  });
  try {
    return await server.ssrLoadModule(id);
  } finally {
    await server.close();
  }
}
