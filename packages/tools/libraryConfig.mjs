import { fileURLToPath } from 'node:url';
import { minifyGlsl } from './minifyGlsl.mjs';
import { entrySources, leftToHost, readManifest } from './publishedPackages.mjs';

/**
 * Vite configuration of a published package: an ES module for each of its exports with a source map, dependencies and
 * peers left to the host, in an emptied dist. Its types come from `bundleTypes`.
 *
 * @param {URL} folder of the package, with a slash at its end
 * @param {import('vite').Rolldown.OutputOptions} [output] more of the output
 * @returns {import('vite').UserConfig}
 */
export function libraryConfig(folder, output = {}) {
  const manifest = readManifest(fileURLToPath(folder));
  return {
    publicDir: false,
    plugins: [minifyGlsl()],
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
