import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { libraryConfig } from '../tools/libraryConfig.mjs';

const source = fileURLToPath(new URL('src/', import.meta.url));
/** Folders of what the main entry does not need at start: other entries, and what is fetched when it is first needed. */
const apart = /^(?:adapters|authoring|effects|lazy|microshaders\/xml)\/|^index\.ts$|commented/;
const isCore = (id: string): boolean => id.startsWith(source) && !apart.test(id.slice(source.length));

/**
 * The published bundle: an ES module for each of the package's exports, what they share in chunks, the peers left to the
 * host.
 */
export default defineConfig(
  libraryConfig(new URL('.', import.meta.url), {
    minify: { compress: true, mangle: { toplevel: true }, codegen: { removeWhitespace: true } },
    chunkFileNames: 'chunks/[name].js',
    // what the main entry needs at start is one file, whichever other entries share it: it is smaller whole
    codeSplitting: { groups: [{ name: 'core', test: isCore }] },
  }),
);
