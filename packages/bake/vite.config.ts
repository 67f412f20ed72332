import { readFileSync, rmSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { defineConfig, type Plugin } from 'vite';
import { libraryConfig } from '../tools/libraryConfig.mjs';

const at = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

/**
 * Adds the worker's source to the source map of the module that contains its text, which Vite leaves empty, and removes
 * the source map of the worker's own script, of which no file is written, from `dist`.
 */
const mapWorker = (): Plugin => ({
  name: 'farol-map-worker',
  writeBundle() {
    const file = at('dist/chunks/worker/bakeWorker.js.map');
    const map = JSON.parse(readFileSync(file, 'utf8')) as Record<string, unknown>;
    map.sources = ['../../../src/worker/bakeWorker.ts'];
    map.sourcesContent = [readFileSync(at('src/worker/bakeWorker.ts'), 'utf8')];
    writeFileSync(file, JSON.stringify(map));
    rmSync(at('dist/assets'), { recursive: true, force: true });
  },
});

const config = libraryConfig(new URL('.', import.meta.url), { preserveModules: true, preserveModulesRoot: 'src' });

/**
 * The published package: one file per module, so that an app loads only the code of its first frame; three is a peer
 * dependency. The worker's text, with xatlas, is inside its module, so that bundlers need not find a file. xatlas's
 * imports for Node are left as they are.
 */
export default defineConfig({
  ...config,
  plugins: [...(config.plugins ?? []), mapWorker()],
  worker: { format: 'es', rolldownOptions: { external: [/^node:/] } },
});
