import { defineConfig } from 'vite';

export default defineConfig({
  base: './',
  build: { chunkSizeWarningLimit: 5000 }, // kB: physics, fetched for scenes that have it, is 4,300
});
