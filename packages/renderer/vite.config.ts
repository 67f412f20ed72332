import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { libraryConfig } from '../tools/libraryConfig.mjs';

const source = fileURLToPath(new URL('src/', import.meta.url));
/** What the main entry does not need at start: other entries, code that is fetched on demand, and files of these alone. */
const apart = [
  'adapters/',
  'authoring/',
  'effects/',
  'lazy/',
  'light-field/',
  'light-profiles/',
  'microshaders/xml/',
  'surfaces/',
  'frame/RecentlyUsed.ts',
  'index.ts',
  'lighting/recordGetters.ts',
  'lights/coneIntersectsSphere.ts',
  'lights/recordLayout.ts',
  'materials/overdrawTwin.ts',
  'microshaders/formatMicroShader.ts',
  'three/NodeDraws.ts',
  'three/WaitingPrograms.ts',
  'three/batchTextures.ts',
  'three/contextLists.ts',
  'three/drawnAsCanvas.ts',
  'three/readPixels.ts',
  'three/shadowFrustum.ts',
];

function isCore(id: string): boolean {
  const path = id.startsWith(source) ? id.slice(source.length) : 'index.ts';
  return !path.includes('commented') && !apart.some((each) => path.startsWith(each));
}

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
