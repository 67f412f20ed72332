import { join, normalize } from 'node:path';
import { fileURLToPath } from 'node:url';
import { minifyGlsl } from './minifyGlsl.mjs';
import { entriesOf, leftToHost, readManifest } from './publishedPackages.mjs';

/** Another entry of a package of Farol's: `@farol/renderer/decals`. */
const FAROL_ENTRY = /^@farol\/[^/]+\/.+/;

/**
 * Vite configuration of a published package: an ES module with a source map for each of its entries, named as the entry is,
 * and all else in `chunks`; dependencies and peers left to the host, in an emptied dist. Imports of other entries of Farol end
 * in `.js`, so that two lines for a package are enough in an import map. Types come from `bundleTypes`.
 *
 * @param {URL} folder - of the package, with a slash at its end
 * @param {import('vite').Rolldown.OutputOptions} [output] - more of the output
 * @returns {import('vite').UserConfig}
 */
export function libraryConfig(folder, output = {}) {
  const path = fileURLToPath(folder);
  const manifest = readManifest(path);
  const names = new Map(entriesOf(manifest).map(({ name, source }) => [join(path, source), name]));
  return {
    publicDir: false,
    plugins: [minifyGlsl()],
    build: {
      target: 'es2022',
      sourcemap: true,
      lib: { entry: Object.fromEntries([...names].map(([source, name]) => [name, source])), formats: ['es'] },
      emptyOutDir: true,
      rolldownOptions: {
        external: leftToHost(manifest),
        // a constant that is written out packs better than a name of its own
        optimization: { inlineConst: { mode: 'all', pass: 3 } },
        output: {
          minify: true,
          entryFileNames: ({ facadeModuleId }) => `${names.get(normalize(facadeModuleId ?? '')) ?? 'chunks/[name]'}.js`,
          chunkFileNames: 'chunks/[name].js',
          paths: (id) => (FAROL_ENTRY.test(id) ? `${id}.js` : id),
          ...output,
        },
      },
    },
  };
}
