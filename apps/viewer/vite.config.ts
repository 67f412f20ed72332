import { defineConfig } from 'vite';

export default defineConfig({
  base: './',
  publicDir: '../../public',
  assetsInclude: ['**/*.ply.gz'],
  resolve: { dedupe: ['three'] },
  build: { target: 'es2022', chunkSizeWarningLimit: 2000 },
});
