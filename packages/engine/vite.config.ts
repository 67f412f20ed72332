import { defineConfig } from 'vite';

/**
 * The published bundle: a file for each module, so that what an app does not need at first comes later; three and the
 * renderer are left to the host. Its types come from `tsc -b`.
 */
export default defineConfig({
  publicDir: false,
  build: {
    target: 'es2022',
    lib: { entry: 'src/index.ts', formats: ['es'], fileName: 'index' },
    emptyOutDir: false,
    rolldownOptions: {
      external: [/^three($|\/)/, /^@farol\/renderer($|\/)/],
      output: { minify: true, preserveModules: true, preserveModulesRoot: 'src', entryFileNames: '[name].js' },
    },
  },
});
