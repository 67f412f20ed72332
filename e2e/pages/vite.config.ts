import { readdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { sourceConditions } from '@farol/tools/sourceConditions';
import { defineConfig } from 'vite';

/** Pages of the browser tests' own, served beside the two apps: each .html here and in a folder of examples/ is one. */
const folder = fileURLToPath(new URL('.', import.meta.url));
const pages = [
  ...readdirSync(folder),
  ...readdirSync(`${folder}/examples`, { recursive: true, encoding: 'utf8' }).map((name) => `examples/${name}`),
].filter((name) => name.endsWith('.html'));

export default defineConfig(({ command }) => ({
  base: './',
  publicDir: '../../public',
  assetsInclude: ['**/*.ply.gz'],
  resolve: {
    dedupe: ['three', 'react', 'react-dom'],
    ...(command === 'serve' ? { conditions: sourceConditions } : {}),
  },
  // bundled at start together: found later, they would be bundled with a second copy of three
  optimizeDeps: {
    entries: pages,
    include: ['three', 'three/tsl', 'three/webgpu', 'three/addons/tsl/WebGLNodesHandler.js'],
  },
  build: {
    target: 'es2022',
    chunkSizeWarningLimit: 2000,
    rolldownOptions: {
      input: pages,
      output: {
        // a page asks for a few files, not for ninety: a browser and Playwright take milliseconds for each
        codeSplitting: {
          groups: [
            { name: 'three', tags: ['$initial'], test: /[\\/]node_modules[\\/]three[\\/]/, priority: 2 },
            { name: 'renderer', tags: ['$initial'], test: /[\\/]packages[\\/]renderer[\\/]/, priority: 1 },
          ],
        },
      },
    },
  },
}));
