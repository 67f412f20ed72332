import { readFileSync } from 'node:fs';
import { defineConfig } from 'vite';

interface Manifest {
  exports: Record<string, { development: string }>;
}
const manifest = JSON.parse(readFileSync(new URL('package.json', import.meta.url), 'utf8')) as Manifest;

/**
 * The published package: a file for each module, so that an app loads code of its first frame alone; three and the
 * renderer are left to the host. Its types come from `tsc -b`.
 */
export default defineConfig({
  publicDir: false,
  build: {
    target: 'es2022',
    lib: { entry: Object.values(manifest.exports).map(({ development }) => development), formats: ['es'] },
    emptyOutDir: false,
    rolldownOptions: {
      external: [/^three($|\/)/, /^@farol\/renderer($|\/)/],
      output: { minify: true, preserveModules: true, preserveModulesRoot: 'src', entryFileNames: '[name].js' },
    },
  },
});
