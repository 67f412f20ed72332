import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { libraryConfig } from '../tools/libraryConfig.mjs';

const mainEntry = join(fileURLToPath(new URL('src', import.meta.url)), 'index.ts');

/** The modules that the main entry imports at start, directly or not; `import()` is not followed. */
const coreModules = new Set<string>();

type Imports = { getModuleInfo(id: string): { importedIds: readonly string[] } | null };

function coreOf(graph: Imports): ReadonlySet<string> {
  if (coreModules.size > 0) return coreModules;
  coreModules.add(mainEntry);
  // iteration of a set goes on to what is added meanwhile
  for (const id of coreModules) for (const each of graph.getModuleInfo(id)?.importedIds ?? []) coreModules.add(each);
  return coreModules;
}

/**
 * The published bundle: an ES module for each of the package's entries, what they share in chunks, the peers left to the
 * host. What the main entry needs at start is one chunk, whichever other entries share it: it is smaller whole.
 */
export default defineConfig(
  libraryConfig(new URL('.', import.meta.url), {
    minify: { compress: true, mangle: { toplevel: true }, codegen: { removeWhitespace: true } },
    codeSplitting: {
      groups: [{ debugName: 'core', name: (id, graph) => (id !== mainEntry && coreOf(graph).has(id) ? 'core' : null) }],
    },
  }),
);
