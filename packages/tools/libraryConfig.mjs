import { fileURLToPath } from 'node:url';
import { bundleTypes } from './bundleTypes.mjs';
import { minifyGlsl } from './minifyGlsl.mjs';
import { entrySources, leftToHost, readManifest } from './publishedPackages.mjs';

/**
 * Vite configuration of a published package: an ES module for each of its exports with source maps and types,
 * dependencies and peers left to the host, in an emptied dist. The types are those that `tsc -b packages` wrote.
 *
 * @param {URL} folder of the package, with a slash at its end
 * @param {import('vite').Rolldown.OutputOptions} [output] more of the output
 * @returns {import('vite').UserConfig}
 */
export function libraryConfig(folder, output = {}) {
  const path = fileURLToPath(folder);
  const manifest = readManifest(path);
  return {
    publicDir: false,
    plugins: [minifyGlsl(), bundleTypes(path)],
    build: {
      target: 'es2022',
      sourcemap: true,
      lib: { entry: entrySources(manifest), formats: ['es'] },
      emptyOutDir: true,
      rolldownOptions: {
        external: leftToHost(manifest),
        output: { minify: true, entryFileNames: '[name].js', ...output },
      },
    },
  };
}
