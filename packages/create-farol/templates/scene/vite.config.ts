import { defineConfig } from 'vite';

export default defineConfig({
  base: './',
  build: { chunkSizeWarningLimit: 5000 }, // kB: physics, fetched where a scene has some, is 4,300
});
