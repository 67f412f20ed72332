import { readdirSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { sourceConditions } from '@farol/tools/sourceConditions';
import { defineConfig } from 'vite';

/** Pages of the browser tests' own: each .html here is one, served beside the two apps. */
const folder = fileURLToPath(new URL('.', import.meta.url));

export default defineConfig(({ command }) => ({
  base: './',
  publicDir: '../../public',
  assetsInclude: ['**/*.ply.gz'],
  resolve: { dedupe: ['three'], ...(command === 'serve' ? { conditions: sourceConditions } : {}) },
  // bundled with three itself: found later, they would bring a three of their own
  optimizeDeps: { include: ['three', 'three/tsl', 'three/webgpu', 'three/addons/tsl/WebGLNodesHandler.js'] },
  build: {
    target: 'es2022',
    chunkSizeWarningLimit: 2000,
    rolldownOptions: { input: readdirSync(folder).filter((name) => name.endsWith('.html')) },
  },
}));
