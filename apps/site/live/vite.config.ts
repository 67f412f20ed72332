import { readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { securePages } from '@farol/tools/contentSecurityPolicy';
import { sourceConditions } from '@farol/tools/sourceConditions';
import react from '@vitejs/plugin-react';
import { defineConfig, type Plugin } from 'vite';

const folderAt = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

/** Copies the files of public/ that a live module names ('./models/streetLamp.glb') into what is built, and no others. */
function namedAssets(): Plugin {
  const here = folderAt('.');
  const modules = readdirSync(here, { recursive: true, encoding: 'utf8' }).filter((path) => /\.tsx?$/.test(path));
  const named = modules.flatMap((path) => [
    ...readFileSync(`${here}/${path}`, 'utf8').matchAll(/'\.\/((?:models|scenes|sounds)\/[^']+)'/g),
  ]);
  return {
    name: 'farol-named-assets',
    apply: 'build',
    generateBundle() {
      for (const fileName of new Set(named.map(([, path]) => path)))
        this.emitFile({ type: 'asset', fileName, source: readFileSync(folderAt(`../../../public/${fileName}`)) });
    },
  };
}

/** Live modules of the site: one page that runs one of them, by its query. */
export default defineConfig(({ command }) => ({
  root: folderAt('.'),
  base: './',
  publicDir: command === 'serve' ? '../../../public' : false,
  plugins: [react(), namedAssets(), securePages()],
  resolve: {
    dedupe: ['three', 'react', 'react-dom'],
    ...(command === 'serve' ? { conditions: sourceConditions } : {}),
  },
  // bundled at start: dependencies found later would be bundled with a second copy of three or React
  optimizeDeps: {
    entries: ['index.html', 'gallery/*', 'thesis/*', 'techniques/*'],
    include: ['@react-three/drei', '@react-three/fiber', 'postprocessing', 'react', 'react-dom/client', 'three'],
  },
  // code that the renderer fetches late comes as chunks
  worker: { format: 'es' },
  build: {
    target: 'es2022',
    emptyOutDir: true,
    manifest: true,
    chunkSizeWarningLimit: 2000,
    rolldownOptions: {
      output: { codeSplitting: { groups: [{ name: 'three', test: /[\\/]three[\\/]build[\\/]/ }] } },
    },
  },
}));
