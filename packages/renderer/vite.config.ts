import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { libraryConfig } from '../tools/libraryConfig.mjs';

const mainEntry = join(fileURLToPath(new URL('src', import.meta.url)), 'index.ts');

/** Modules that the main entry imports statically, directly or indirectly. */
const coreModules = new Set<string>();

type Imports = { getModuleInfo(id: string): { importedIds: readonly string[] } | null };

function coreOf(graph: Imports): ReadonlySet<string> {
  if (coreModules.size > 0) return coreModules;
  coreModules.add(mainEntry);
  // iterating a set also visits members added meanwhile
  for (const id of coreModules) for (const each of graph.getModuleInfo(id)?.importedIds ?? []) coreModules.add(each);
  return coreModules;
}

/**
 * The published bundle: an ES module for each of the package's entries, shared chunks, and peer dependencies left to the host.
 * All static imports of the main entry form one chunk, since that compresses better.
 */
export default defineConfig(
  libraryConfig(new URL('.', import.meta.url), {
    minify: { compress: true, mangle: { toplevel: true }, codegen: { removeWhitespace: true } },
    codeSplitting: {
      groups: [{ debugName: 'core', name: (id, graph) => (id !== mainEntry && coreOf(graph).has(id) ? 'core' : null) }],
    },
  }),
);
