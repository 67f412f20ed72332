import { readFileSync, rmSync, writeFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { defineConfig, type Plugin } from 'vite';
import { libraryConfig } from '../tools/libraryConfig.mjs';

const at = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

/**
 * Names the worker's source in the map of the module that holds its text: Vite leaves that map without a source. The map
 * of the worker's own script, of which no file is written, is taken out of `dist`.
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
 * The published package: a file for each module, so that an app loads code of its first frame alone; three is left to the
 * host. The worker is within its module, xatlas and all: no tool of a host has to find a file. What xatlas imports in Node
 * stays as it is.
 */
export default defineConfig({
  ...config,
  plugins: [...(config.plugins ?? []), mapWorker()],
  worker: { format: 'es', rolldownOptions: { external: [/^node:/] } },
});
