import { defineConfig } from 'vite';
import { minifyGlsl } from '../tools/minifyGlsl.mjs';

/** The published bundle: one ES module, three left to the host. Its types come from `tsc -b`. */
export default defineConfig({
  publicDir: false,
  plugins: [minifyGlsl()],
  build: {
    target: 'es2022',
    lib: { entry: 'src/index.ts', formats: ['es'], fileName: 'index' },
    emptyOutDir: false,
    rolldownOptions: { external: [/^three($|\/)/], output: { minify: true } },
  },
});
