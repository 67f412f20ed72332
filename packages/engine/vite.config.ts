import { defineConfig } from 'vite';

/** The published bundle: one ES module, three and the renderer left to the host. Its types come from `tsc -b`. */
export default defineConfig({
  publicDir: false,
  build: {
    target: 'es2022',
    lib: { entry: 'src/index.ts', formats: ['es'], fileName: 'index' },
    emptyOutDir: false,
    rolldownOptions: { external: [/^three($|\/)/, '@farol/renderer'], output: { minify: true } },
  },
});
