/**
 * Writes the files of the editor's samples to `public/scenes`, by the engine's own classes; the same files in every run.
 *
 *     node packages/tools/makeSamples.mjs
 */
import { mkdirSync, writeFileSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { join } from 'node:path';
import { createServer } from 'vite';
import { root } from './root.mjs';
import { serverSourceConditions } from './sourceConditions.mjs';

const folder = join(root, 'public/scenes');
mkdirSync(folder, { recursive: true });
const server = await createServer({
  root,
  configFile: false,
  logLevel: 'error',
  appType: 'custom',
  server: { middlewareMode: true, hmr: false, watch: null, ws: false },
  optimizeDeps: { noDiscovery: true },
  ssr: { noExternal: [/^@farol\//], resolve: { conditions: serverSourceConditions } },
});
try {
  const { makeSample, sampleMakers } =
    /** @type {{ makeSample(file: string, readPublic: (path: string) => Promise<Uint8Array>): Promise<Uint8Array>, sampleMakers: Record<string, unknown> }} */ (
      await server.ssrLoadModule('/apps/editor/src/samples/makeSamples.ts')
    );
  for (const file of Object.keys(sampleMakers)) {
    const bytes = await makeSample(file, (path) => readFile(join(root, 'public', path)));
    writeFileSync(join(folder, file), bytes);
    console.log(`${file}: ${(bytes.length / 1000).toFixed(1)} kB`);
  }
} finally {
  await server.close();
}
