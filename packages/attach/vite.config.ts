import { defineConfig } from 'vite';

/**
 * The published bundle: one ES module, three and the renderer left to the host; of the engine only its declarations of
 * fields are in it. Its types come from `tsc -b`.
 */
export default defineConfig({
  publicDir: false,
  resolve: { conditions: ['development', 'module', 'browser'] },
  build: {
    target: 'es2022',
    lib: { entry: 'src/index.ts', formats: ['es'], fileName: 'index' },
    emptyOutDir: false,
    rolldownOptions: { external: [/^three($|\/)/, /^@farol\/renderer($|\/)/], output: { minify: true } },
  },
});
