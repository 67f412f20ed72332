import react from '@vitejs/plugin-react';
import { defineConfig } from 'vite';

export default defineConfig({
  base: './',
  publicDir: '../../public',
  assetsInclude: ['**/*.ply.gz'],
  plugins: [react()],
  server: { port: 5173, strictPort: true },
  resolve: { dedupe: ['three', 'react', 'react-dom'] },
  build: { target: 'es2022', chunkSizeWarningLimit: 2000 },
});
