import { fileURLToPath } from 'node:url';
import { securePages } from '@farol/tools/contentSecurityPolicy';
import { sourceConditions } from '@farol/tools/sourceConditions';
import react from '@vitejs/plugin-react';
import { defineConfig } from 'vite';

/** Live modules of the site: one page that runs one of them, by its query. Built into `../dist/live`. */
export default defineConfig(({ command }) => ({
  root: fileURLToPath(new URL('.', import.meta.url)),
  base: './',
  publicDir: 'assets',
  plugins: [react(), securePages()],
  resolve: {
    dedupe: ['three', 'react', 'react-dom'],
    ...(command === 'serve' ? { conditions: sourceConditions } : {}),
  },
  optimizeDeps: { entries: ['index.html', 'gallery/*', 'thesis/*', 'techniques/*'] },
  build: {
    target: 'es2022',
    outDir: fileURLToPath(new URL('../dist/live/', import.meta.url)),
    emptyOutDir: true,
    manifest: true,
    chunkSizeWarningLimit: 2000,
  },
}));
