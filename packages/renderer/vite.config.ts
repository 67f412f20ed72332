import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { minifyGlsl } from '../tools/minifyGlsl.mjs';

interface Manifest {
  exports: Record<string, { development: string; default: string }>;
  peerDependencies: Record<string, string>;
}
const manifest = JSON.parse(readFileSync(new URL('package.json', import.meta.url), 'utf8')) as Manifest;
const peers = Object.keys(manifest.peerDependencies);

const source = fileURLToPath(new URL('src/', import.meta.url));
/** Folders of what the main entry does not need at start: other entries, and what is fetched when it is first needed. */
const apart = /^(?:adapters|authoring|effects|lazy|microshaders\/xml)\/|^index\.ts$|commented/;
const isCore = (id: string): boolean => id.startsWith(source) && !apart.test(id.slice(source.length));

/**
 * The published bundle: an ES module for each of the package's exports, what they share in chunks, the peers left to the
 * host. Its types come from `tsc -b`.
 */
export default defineConfig({
  publicDir: false,
  plugins: [minifyGlsl()],
  build: {
    target: 'es2022',
    lib: {
      entry: Object.fromEntries(
        Object.values(manifest.exports).map((paths) => [
          paths.default.replace(/^\.\/dist\/|\.js$/g, ''),
          paths.development,
        ]),
      ),
      formats: ['es'],
    },
    emptyOutDir: false,
    rolldownOptions: {
      external: (id) => peers.some((peer) => id === peer || id.startsWith(`${peer}/`)),
      output: {
        minify: { compress: true, mangle: { toplevel: true }, codegen: { removeWhitespace: true } },
        entryFileNames: '[name].js',
        chunkFileNames: 'chunks/[name].js',
        // what the main entry needs at start is one file, whichever other entries share it: it is smaller whole
        codeSplitting: { groups: [{ name: 'core', test: isCore }] },
      },
    },
  },
});
